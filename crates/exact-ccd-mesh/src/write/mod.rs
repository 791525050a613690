//! Mesh files out of frames: one writer a format.

mod ply;
mod pvd;
mod vtu;

pub use pvd::write_pvd;
pub use vtu::UnstructuredGrid;
