//! Triangle meshes in motion: mesh files, the broad phase, and the collision-free step of a whole mesh.

mod mesh;

pub use exact_ccd::Point;
pub use mesh::{IndexOutOfRange, TriangleMesh};
