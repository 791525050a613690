//! The removal of files in the folder of the results, and of drafts that an earlier run left there.

use std::path::Path;
use std::{fs, io};

/// The name of the file to which a draft of [`replace_file`](crate::files::outputs::replace_file) belongs, or
/// none for other names.
pub(crate) fn draft_of(name: &str) -> Option<&str> {
    let (file, number) = name.strip_prefix('.')?.rsplit_once('.')?;
    is_number(number).then_some(file)
}

/// Removes the files in a folder whose names match. A missing folder is not an error.
pub(crate) fn remove_files(folder: &Path, matches: impl Fn(&str) -> bool) -> io::Result<()> {
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        entries => entries?,
    };
    for entry in entries {
        let entry = entry?;
        if entry.file_name().to_str().is_some_and(&matches) && entry.file_type()?.is_file() {
            fs::remove_file(entry.path())?;
        }
    }
    Ok(())
}

/// Returns true for a non-empty text of digits only.
pub(crate) fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}
