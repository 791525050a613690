//! CSV tables with a row for each time step, which grow with the simulation.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::marker::PhantomData;
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::files::outputs::write_file;
use crate::messages::failure::Failure;

/// A CSV file with a header and a row for each time step.
pub(crate) struct Log<R> {
    file: PathBuf,
    is_empty: bool,
    rows: PhantomData<R>,
}

impl<R: Serialize + DeserializeOwned> Log<R> {
    /// Replaces the file by an empty log.
    pub(crate) fn begin(file: PathBuf) -> Result<Self, Failure> {
        Self::with(file, &[])
    }

    /// The log in a file, without the rows after the time step `last`; `step` has the time step of a row.
    /// Empty if there is no file.
    pub(crate) fn resume(file: PathBuf, last: u64, step: impl Fn(&R) -> u64) -> Result<Self, Failure> {
        let mut rows: Vec<R> = read(&file)?;
        rows.retain(|row| step(row) <= last);
        Self::with(file, &rows)
    }

    fn with(file: PathBuf, rows: &[R]) -> Result<Self, Failure> {
        write_rows(&file, rows)?;
        Ok(Self {
            file,
            is_empty: rows.is_empty(),
            rows: PhantomData,
        })
    }

    /// Adds a row with a single write, without waiting for the disk.
    pub(crate) fn add(&mut self, row: &R) -> Result<(), Failure> {
        let append = || -> io::Result<()> {
            let mut line = Vec::new();
            let mut writer = csv::WriterBuilder::new()
                .has_headers(self.is_empty)
                .from_writer(&mut line);
            writer.serialize(row)?;
            writer.flush()?;
            drop(writer);
            let mut file = OpenOptions::new().append(true).open(&self.file)?;
            file.write_all(&line)
        };
        append().map_err(|source| Failure::write(&self.file, source))?;
        self.is_empty = false;
        Ok(())
    }

    /// Waits until all rows are on disk.
    pub(crate) fn sync(&self) -> Result<(), Failure> {
        let synced = OpenOptions::new().append(true).open(&self.file);
        let synced = synced.and_then(|file| file.sync_data());
        synced.map_err(|source| Failure::write(&self.file, source))
    }

    /// All rows.
    pub(crate) fn rows(&self) -> Result<Vec<R>, Failure> {
        read(&self.file)
    }
}

/// Writes a table with these rows, and replaces an existing one.
pub(crate) fn write_rows(file: &Path, rows: &[impl Serialize]) -> Result<(), Failure> {
    write_file(file, |writer| {
        let mut writer = csv::Writer::from_writer(writer);
        rows.iter().try_for_each(|row| writer.serialize(row))?;
        writer.flush()
    })
}

/// The rows of a file. Empty if there is no file. A last line without a line break is ignored: the program
/// was ended in the middle of it.
fn read<R: DeserializeOwned>(path: &Path) -> Result<Vec<R>, Failure> {
    let failed = |source: csv::Error| Failure::of(path, source);
    let bytes = match std::fs::read(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        bytes => bytes.map_err(|error| failed(error.into()))?,
    };
    let end = bytes.iter().rposition(|&byte| byte == b'\n');
    let rows = csv::Reader::from_reader(&bytes[..end.map_or(0, |end| end + 1)]).into_deserialize();
    rows.collect::<Result<_, _>>().map_err(failed)
}
