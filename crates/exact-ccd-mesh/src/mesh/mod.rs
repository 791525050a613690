//! Meshes at one time: connectivity and positions, of triangles with rods and points, and of tetrahedra.

mod boundary;
mod components;
mod connectivity;
mod disjoint_sets;
mod face_counts;
mod frame;
mod joined;
mod positions;
mod tet_error;
mod tet_mesh;

pub use boundary::TetFaces;
pub use connectivity::{MeshError, TriangleMesh};
pub use frame::{Frame, FrameError};
pub use positions::{PositionsError, check_positions};
pub use tet_error::TetMeshError;
pub use tet_mesh::TetMesh;

pub(crate) use connectivity::sides;
pub(crate) use disjoint_sets::DisjointSets;
