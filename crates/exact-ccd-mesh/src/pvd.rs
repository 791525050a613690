//! Collections of files, each of which shows one time.

use std::path::{Path, PathBuf};

use crate::read::{self, ReadError};

/// The times and files in a collection of ParaView's, `.pvd`, in its order: what [`write_pvd`](crate::write_pvd) writes.
///
/// Paths in it are taken from the folder in which it is.
///
/// # Errors
/// [`ReadError`] names the file, the line, and what was expected there.
pub fn read_pvd(path: impl AsRef<Path>) -> Result<Vec<(f64, PathBuf)>, ReadError> {
    read::read_pvd(path.as_ref())
}
