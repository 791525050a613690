//! Frames from files of every format.

use std::path::Path;

use exact_ccd_mesh::Frame;

use super::file::parse_file;
use super::{msh, obj, off, ply, stl, vtk};
use crate::error::{ParseError, ReadError};
use crate::format::Format;

/// Reads the frame in a file. The extension determines the format, see [`Format::of_path`].
///
/// Vertices and faces keep their numbers in the file, counted from 0. Each coordinate is the `f64`
/// nearest to the decimal text, or exactly the binary number. An STL file has no shared vertices:
/// it reads as three vertices for each face. A .msh file of tetrahedra reads as the surface alone,
/// see [`surface_frame`](exact_ccd_mesh::TetMesh::surface_frame), and its loose edges. A .vtu file of
/// tetrahedra reads as the surface, and triangles, lines and points beside it; its tetrahedra count
/// as positive in the order of their corners.
///
/// # Errors
/// [`ReadError`] names the file, the place in it, and what was expected there.
pub fn read_frame(path: impl AsRef<Path>) -> Result<Frame, ReadError> {
    let path = path.as_ref();
    let format = Format::of_path(path).ok_or_else(|| ReadError::Extension {
        path: path.to_owned(),
    })?;
    parse_file(path, |bytes| parse_frame(bytes, format))
}

/// Parses the contents of a file, with the same result as [`read_frame`].
///
/// ```
/// use exact_ccd_files::{Format, parse_frame};
///
/// let frame = parse_frame(b"v 0 0 0\nv 0.1 0 0\nv 0 1 0\nv 0 2 0\nf 1 2 3\nl 3 4\n", Format::Obj)?;
/// assert_eq!(frame.positions[1], [0.1, 0.0, 0.0]);
/// assert_eq!(frame.mesh.faces(), [[0, 1, 2]]);
/// assert_eq!(frame.mesh.loose_edges(), [[2, 3]]);
///
/// let error = parse_frame(b"v 0 0 zero", Format::Obj).unwrap_err();
/// assert_eq!(error.to_string(), "line 1: expected a number, found `zero`");
/// # Ok::<(), exact_ccd_files::ParseError>(())
/// ```
///
/// # Errors
/// [`ParseError`] names the place and what was expected there.
pub fn parse_frame(bytes: &[u8], format: Format) -> Result<Frame, ParseError> {
    match format {
        Format::Ply => ply::read(bytes)?.into_frame(),
        Format::Obj => obj::read(bytes)?.into_frame(),
        Format::Stl => stl::read(bytes)?.into_frame(),
        Format::Off => off::read(bytes)?.into_frame(),
        Format::Msh => msh::read(bytes)?.into_surface(),
        Format::Vtu => vtk::read_grid(bytes)?.into_scene(),
    }
}
