//! Mesh files: one reader a format, all with the same errors.

mod binary;
mod cells;
mod error;
mod msh;
mod obj;
mod off;
mod ply;
mod stl;
mod text;
mod vtk;

use std::path::{Path, PathBuf};

use exact_ccd::Point;

pub use error::{Fault, ParseError, Place, ReadError};

use crate::frame::Frame;
use crate::tet_mesh::TetMesh;

/// A format of mesh files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// The Stanford polygon format: text, or binary of either byte order.
    Ply,
    /// Wavefront OBJ.
    Obj,
    /// Stereolithography: text or binary.
    Stl,
    /// The Object File Format of Geomview, as text.
    Off,
    /// Gmsh's MSH, version 2.2 or 4.1: text, or binary of either byte order. Tetrahedra read as their surface.
    Msh,
    /// VTK's XML format of unstructured grids: data inline, as text or in base64, not compressed. Tetrahedra read as their
    /// surface, and other triangles beside them as they are.
    Vtu,
}

impl Format {
    /// The format that the extension of a path tells, in upper or lower case.
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "ply" => Some(Self::Ply),
            "obj" => Some(Self::Obj),
            "stl" => Some(Self::Stl),
            "off" => Some(Self::Off),
            "msh" => Some(Self::Msh),
            "vtu" => Some(Self::Vtu),
            _ => None,
        }
    }
}

/// The times and files of a collection, as seen from where one is.
pub(crate) fn read_pvd(path: &Path) -> Result<Vec<(f64, PathBuf)>, ReadError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let entries = parse_file(path, vtk::read_collection)?;
    Ok(entries
        .into_iter()
        .map(|(time, file)| (time, folder.join(file)))
        .collect())
}

/// What a reader finds: positions, and faces whose indices it has checked.
type Contents = (Vec<Point>, Vec<[u32; 3]>);

pub(crate) fn read(path: &Path) -> Result<Frame, ReadError> {
    let format = Format::of_path(path).ok_or_else(|| ReadError::Extension {
        path: path.to_owned(),
    })?;
    parse_file(path, |bytes| parse(bytes, format))
}

pub(crate) fn read_tet_mesh(path: &Path) -> Result<TetMesh, ReadError> {
    parse_file(path, parse_tet_mesh)
}

fn parse_file<T>(path: &Path, parse: impl FnOnce(&[u8]) -> Result<T, ParseError>) -> Result<T, ReadError> {
    let bytes = std::fs::read(path).map_err(|source| ReadError::Io {
        path: path.to_owned(),
        source,
    })?;
    parse(&bytes).map_err(|source| ReadError::Parse {
        path: path.to_owned(),
        source,
    })
}

pub(crate) fn parse_tet_mesh(bytes: &[u8]) -> Result<TetMesh, ParseError> {
    msh::read(bytes)?.into_tet_mesh()
}

pub(crate) fn parse(bytes: &[u8], format: Format) -> Result<Frame, ParseError> {
    let (positions, faces) = match format {
        Format::Ply => ply::read(bytes),
        Format::Obj => obj::read(bytes),
        Format::Stl => stl::read(bytes),
        Format::Off => off::read(bytes),
        Format::Msh => return msh::read(bytes)?.into_frame(),
        Format::Vtu => return vtk::read_grid(bytes)?.into_scene(),
    }?;
    Frame::new(positions, faces).map_err(|error| Fault::Frame(error).at(Place::File))
}

/// The index of a vertex of face `face`, as a file writes it, counted from 0.
fn vertex_index(face: usize, index: i64, vertex_count: u64, place: Place) -> Result<u32, ParseError> {
    let in_range = |&index: &u32| u64::from(index) < vertex_count;
    u32::try_from(index).ok().filter(in_range).ok_or_else(|| {
        Fault::Index {
            face,
            index,
            first: 0,
            vertex_count,
        }
        .at(place)
    })
}
