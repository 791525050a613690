//! Writers: one for each format.

mod check;
mod grid;
mod obj;
mod ply;
mod pvd;
mod vtp;
mod vtu;
mod xml;

pub use grid::UnstructuredGrid;
pub use obj::{with_obj_positions, write_obj};
pub use ply::{write_ply, write_ply_with_parts};
pub use pvd::write_pvd;
pub use vtp::{PointArray, write_vtp};
pub use vtu::write_vtu;
