//! Collections: one file for each time.

use std::path::{Path, PathBuf};

use super::file::parse_file;
use super::vtk;
use crate::error::ReadError;

/// Reads the times and files of a ParaView collection, `.pvd`, in its order.
/// [`write_pvd`](crate::write_pvd) writes one.
///
/// Paths in the collection are relative to its folder.
///
/// # Errors
/// [`ReadError`] names the file, the line, and what was expected there.
pub fn read_pvd(path: impl AsRef<Path>) -> Result<Vec<(f64, PathBuf)>, ReadError> {
    let path = path.as_ref();
    let folder = path.parent().unwrap_or(Path::new(""));
    let entries = parse_file(path, vtk::read_collection)?;
    let entries = entries.into_iter();
    Ok(entries.map(|(time, file)| (time, folder.join(file))).collect())
}
