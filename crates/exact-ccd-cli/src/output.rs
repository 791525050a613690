//! What the program writes: its answer, and files.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::process;

use crate::failure::Failure;

/// Prints the whole answer. That nobody reads it is no failure.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    let mut output = io::stdout().lock();
    writeln!(output, "{text}")
        .and_then(|()| output.flush())
        .map_err(Failure::Output)
        .or_else(Failure::unless_closed_pipe)
}

/// Writes a file, in place of what was there.
pub(crate) fn write_file(
    file: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), Failure> {
    replace_file(file, |writer| {
        write(writer).map_err(|source| Failure::write(file, source))
    })
}

/// Writes a file, in place of what was there: all of it, or nothing if this fails.
pub(crate) fn replace_file(
    file: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    // What is no plain file, as /dev/stdout, cannot be replaced.
    let is_plain = fs::metadata(file).map_or(true, |metadata| metadata.is_file());
    let target = fs::canonicalize(file).unwrap_or_else(|_| file.to_owned());
    let (created, draft) = match target.file_name().filter(|_| is_plain) {
        None => (File::create(file), None),
        Some(name) => {
            let mut draft = OsString::from(".");
            draft.push(name);
            draft.push(format!(".{}", process::id()));
            let draft = target.with_file_name(draft);
            (File::create_new(&draft), Some(draft))
        }
    };
    let failed = |source| Failure::write(file, source);
    let mut writer = BufWriter::new(created.map_err(failed)?);
    let written = write(&mut writer)
        .and_then(|()| writer.flush().map_err(failed))
        .and_then(|()| {
            draft
                .as_ref()
                .map_or(Ok(()), |draft| fs::rename(draft, &target).map_err(failed))
        });
    if let (Err(_), Some(draft)) = (&written, &draft) {
        // The error that led here matters more.
        let _ = fs::remove_file(draft);
    }
    written
}
