//! What the program writes: its answer, and files.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

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
    let written = File::create(file).and_then(|created| {
        let mut writer = BufWriter::new(created);
        write(&mut writer)?;
        writer.flush()
    });
    written.map_err(|source| Failure::write(file, source))
}
