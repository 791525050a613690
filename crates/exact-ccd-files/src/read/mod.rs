//! Readers: one for each format, all with the same errors.

mod budget;
mod cells;
mod compressed;
mod content;
mod file;
mod frame;
mod gltf;
mod group;
#[cfg(test)]
mod hostile;
mod mesh_file;
mod motion;
mod msh;
mod numpy;
mod obj;
mod off;
mod options;
mod ply;
mod polygons;
mod record;
mod scalar;
mod sequence;
mod series;
mod solids;
mod stl;
mod tet_mesh;
mod tokens;
mod vtk;
mod zip;

pub use budget::Budget;
pub use frame::{parse_frame, read_frame};
pub use group::{Group, PhysicalTag};
pub use mesh_file::MeshFile;
pub use motion::{ReadMotionError, read_motion};
pub use options::{Polygons, ReadOptions};
pub use sequence::FrameSequence;
pub use series::{read_pvd, read_series};
pub use tet_mesh::{parse_tet_groups, parse_tet_mesh, read_tet_groups, read_tet_mesh};
