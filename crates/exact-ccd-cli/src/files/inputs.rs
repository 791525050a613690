//! The inputs of a command: files and folders that must be there before anything is computed.

use std::fs::{self, File, Metadata};
use std::io;
use std::path::Path;

use crate::messages::failure::Failure;

/// Checks that a file can be read. `expected` names its contents.
#[cfg(feature = "queries")]
pub(crate) fn check_file(path: &Path, expected: &'static str) -> Result<(), Failure> {
    check(path, expected, |metadata| {
        metadata.is_dir().then_some("this is a folder")
    })
}

/// Checks that a folder can be read. `expected` names its contents.
#[cfg(feature = "queries")]
pub(crate) fn check_folder(path: &Path, expected: &'static str) -> Result<(), Failure> {
    check(path, expected, |metadata| {
        (!metadata.is_dir()).then_some("this is no folder")
    })
}

/// Checks that a file or a folder can be read. `expected` names its contents.
pub(crate) fn check_path(path: &Path, expected: &'static str) -> Result<(), Failure> {
    check(path, expected, |_| None)
}

fn check(
    path: &Path,
    expected: &'static str,
    is_other: impl Fn(&Metadata) -> Option<&'static str>,
) -> Result<(), Failure> {
    let error = |found: &str, remedy| Failure::of(path, format_args!("{found}, expected {expected}{remedy}"));
    let failed = |source: io::Error| match source.kind() {
        io::ErrorKind::NotFound => error(
            "no such file or folder",
            ": check the name, and the folder in which the program runs",
        ),
        io::ErrorKind::PermissionDenied => error(
            "reading is not permitted",
            ": change its permissions, or those of the folders around it",
        ),
        _ => error(&source.to_string(), ""),
    };
    let metadata = fs::metadata(path).map_err(failed)?;
    if let Some(found) = is_other(&metadata) {
        return Err(error(found, ""));
    }
    // A pipe can be opened only once.
    if metadata.is_dir() {
        fs::read_dir(path).map_err(failed)?;
    } else if metadata.is_file() {
        File::open(path).map_err(failed)?;
    }
    Ok(())
}

/// The last part of a path.
pub(crate) fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}
