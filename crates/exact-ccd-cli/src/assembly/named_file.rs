//! The names of parts on the command line.

use std::path::{Path, PathBuf};

/// The name of a part and its file: NAME=FILE, unless there is such a file. Otherwise the name is the name of
/// the file, up to the first dot.
pub(super) fn named(path: &Path) -> (String, PathBuf) {
    let text = path.to_string_lossy();
    if let Some((name, file)) = text.split_once('=')
        && !name.is_empty()
        && !path.exists()
    {
        return (name.to_owned(), file.into());
    }
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    let stem = name.split('.').find(|stem| !stem.is_empty()).unwrap_or("part");
    (stem.to_owned(), path.to_owned())
}
