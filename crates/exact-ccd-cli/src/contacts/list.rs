//! Lists of all contacts, in files.

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::str::FromStr;

#[cfg(feature = "queries")]
use exact_ccd_data::TableColumn;

#[cfg(feature = "queries")]
use super::cells::Cell;
use super::cells::row;
use super::record::ContactRecord;
use crate::files::outputs::write_file;
#[cfg(not(feature = "queries"))]
use crate::left_out;
use crate::messages::failure::Failure;

/// A file for a list of contacts. Its extension is the format.
#[derive(Clone, Debug)]
pub(crate) struct ListFile {
    path: PathBuf,
    format: Format,
}

#[derive(Clone, Copy, Debug)]
enum Format {
    Csv,
    JsonLines,
    #[cfg(feature = "queries")]
    Parquet,
}

impl ListFile {
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }
}

impl FromStr for ListFile {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let path = PathBuf::from(text);
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        let format = match extension.to_str() {
            Some("csv") => Format::Csv,
            Some("jsonl" | "ndjson") => Format::JsonLines,
            #[cfg(feature = "queries")]
            Some("parquet") => Format::Parquet,
            #[cfg(not(feature = "queries"))]
            Some("parquet") => return Err(left_out::message("Parquet", "queries", "step")),
            _ => return Err("expected a file name that ends in .csv, .jsonl or .parquet".to_owned()),
        };
        Ok(Self { path, format })
    }
}

/// Contacts and intersections, in the order of time.
#[derive(Default)]
pub(crate) struct ContactList(pub(crate) Vec<ContactRecord>);

impl ContactList {
    /// Writes the list to a file, which is replaced.
    pub(crate) fn write(&self, file: &ListFile) -> Result<(), Failure> {
        write_file(&file.path, |writer| match file.format {
            Format::Csv => self.csv(writer),
            Format::JsonLines => self.json_lines(writer),
            #[cfg(feature = "queries")]
            Format::Parquet => self.parquet(writer),
        })
    }

    fn csv(&self, writer: &mut BufWriter<impl Write>) -> io::Result<()> {
        let header = row(&ContactRecord::default()).map(|(name, _)| name);
        writeln!(writer, "{}", header.join(","))?;
        for record in &self.0 {
            let cells = row(record).map(|(_, cell)| cell.to_string());
            writeln!(writer, "{}", cells.join(","))?;
        }
        Ok(())
    }

    #[cfg(feature = "queries")]
    fn parquet(&self, writer: impl Write + Send) -> io::Result<()> {
        // The columns of a list without rows have their types, too.
        let mut columns = row(&ContactRecord::default()).map(|(name, cell)| match cell {
            Cell::Text(_) => (name, TableColumn::Text(Vec::new())),
            Cell::Integer(_) => (name, TableColumn::Integers(Vec::new())),
            Cell::Real(_) => (name, TableColumn::Reals(Vec::new())),
        });
        for row in self.0.iter().map(row) {
            for ((_, column), (_, cell)) in columns.iter_mut().zip(row) {
                match (column, cell) {
                    (TableColumn::Text(values), Cell::Text(text)) => values.push(text),
                    (TableColumn::Integers(values), Cell::Integer(value)) => values.push(value),
                    (TableColumn::Reals(values), Cell::Real(value)) => values.push(value),
                    _ => {}
                }
            }
        }
        exact_ccd_data::write_table(writer, &columns)
    }

    fn json_lines(&self, writer: &mut BufWriter<impl Write>) -> io::Result<()> {
        for record in &self.0 {
            serde_json::to_writer(&mut *writer, record)?;
            writeln!(writer)?;
        }
        Ok(())
    }
}
