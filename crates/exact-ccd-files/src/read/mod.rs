//! Readers: one for each format, all with the same errors.

mod binary;
mod cells;
mod file;
mod frame;
mod motion;
mod msh;
mod obj;
mod off;
mod ply;
mod pvd;
mod stl;
mod tet_mesh;
mod text;
mod vtk;

pub use frame::{parse_frame, read_frame};
pub use motion::{ReadMotionError, read_motion};
pub use pvd::read_pvd;
pub use tet_mesh::{parse_tet_mesh, read_tet_mesh};
