//! Frames from files of every format.

use std::path::Path;

use exact_ccd_mesh::Frame;

use super::file::{format_of, parse_bytes, parse_file};
use super::mesh_file::assemble;
use crate::error::{ParseError, ReadError};
use crate::format::Format;

/// Reads the frame in a file like [`MeshFile::read`](crate::MeshFile::read), with polygons triangulated.
///
/// # Errors
/// [`ReadError`] names the file, the place in it, and what was expected there.
pub fn read_frame(path: impl AsRef<Path>) -> Result<Frame, ReadError> {
    let path = path.as_ref();
    let format = format_of(path)?;
    parse_file(path, u64::MAX, |bytes, budget| {
        Ok(assemble(bytes, format, path.parent(), budget)?.frame)
    })
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
    parse_bytes(bytes, u64::MAX, |bytes, budget| {
        Ok(assemble(bytes, format, None, budget)?.frame)
    })
}
