//! Readers: one for each format, all with the same errors.

mod budget;
mod cells;
mod compressed;
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
mod point_cache;
mod polygons;
mod recognise;
mod record;
mod recording;
mod scalar;
mod sequence;
mod series;
mod solids;
mod stl;
mod tet_mesh;
mod tokens;
mod volumes;
mod vtk;
mod zip;

use std::path::Path;

use crate::error::ParseError;
use crate::format::Format;
use cells::Cells;

pub use budget::Budget;
pub use frame::{parse_frame, read_frame};
pub use group::{Group, PhysicalTag};
pub use mesh_file::MeshFile;
pub use motion::{ReadMotionError, read_motion};
pub use options::{Polygons, ReadOptions};
pub use sequence::FrameSequence;
pub use series::read_pvd;
pub use tet_mesh::{parse_tet_mesh, read_tet_mesh};

/// The contents of a file. The files that it refers to are in `folder`.
fn read_cells(
    bytes: &[u8],
    format: Format,
    folder: Option<&Path>,
    budget: &Budget,
) -> Result<Cells, ParseError> {
    match format {
        Format::Ply => ply::read(bytes, budget),
        Format::Obj => obj::read(bytes, budget),
        Format::Stl => stl::read(bytes, budget),
        Format::Off => off::read(bytes, budget),
        Format::Msh => msh::read(bytes, budget),
        Format::Vtu => vtk::read_grid(bytes, "UnstructuredGrid", budget),
        Format::Vtp => vtk::read_grid(bytes, "PolyData", budget),
        Format::Vtk => vtk::read_legacy(bytes, budget),
        Format::Gltf => gltf::read(bytes, folder, budget),
        Format::Npy => numpy::read_npy(bytes, budget)?.into_single(),
        Format::Npz => numpy::read_npz(bytes, &numpy::Names::default(), budget)?.into_single(),
    }
}
