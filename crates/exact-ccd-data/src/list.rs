//! The contents of a folder.

use std::path::{Path, PathBuf};
use std::{fs, io};

use crate::error::DataError;

/// The files and folders in a folder, sorted by name.
///
/// # Errors
/// If the folder cannot be read.
pub fn list(folder: &Path) -> Result<Vec<PathBuf>, DataError> {
    let error = |source| DataError::io(folder, source);
    let entries = fs::read_dir(folder).map_err(error)?;
    let path = |entry: io::Result<fs::DirEntry>| entry.map(|entry| entry.path()).map_err(error);
    let mut paths = entries.map(path).collect::<Result<Vec<_>, _>>()?;
    paths.sort();
    Ok(paths)
}
