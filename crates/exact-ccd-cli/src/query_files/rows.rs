//! Query files, in rows or in columns, and queries on standard input.

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use exact_ccd::Kind;
use exact_ccd_data::{ColumnWriter, QueryReader, QueryWriter, Record, Rounding, Sample, Seventh, is_parquet};
use exact_ccd_methods::parity::RoundingError;

use crate::files::outputs::{is_dash, replace_file};
use crate::messages::failure::Failure;

/// The number of queries that are read before they are answered in parallel.
pub(crate) const BATCH: usize = 4096;

/// The queries of a file, read one after the other.
pub(crate) type Samples<K> = Box<dyn Iterator<Item = Result<Sample<K>, Failure>>>;

/// The queries of a file with all their data, read one after the other.
pub(crate) type Records<K> = Box<dyn Iterator<Item = Result<Record<K>, Failure>>>;

/// The meaning of the seventh column, which depends on `--roots`.
pub(crate) fn seventh(roots: bool) -> Seventh {
    if roots { Seventh::Count } else { Seventh::Contact }
}

/// Checks all files but standard input.
pub(crate) fn check(files: &[PathBuf], check: impl Fn(&Path) -> Result<(), Failure>) -> Result<(), Failure> {
    let mut files = files.iter().filter(|file| !is_dash(file));
    files.try_for_each(|file| check(file))
}

/// The queries in a file; - is standard input.
pub(crate) fn open<K: Kind>(file: &Path, rounding: Rounding) -> Result<Samples<K>, Failure> {
    let records = records(file, rounding, Seventh::Contact)?;
    Ok(Box::new(
        records.map(|record| record.map(|record: Record<K>| record.sample)),
    ))
}

/// The queries in a file with all their data; - is standard input.
pub(crate) fn records<K: Kind>(
    file: &Path,
    rounding: Rounding,
    seventh: Seventh,
) -> Result<Records<K>, Failure> {
    let records: exact_ccd_data::Records<K> = if is_dash(file) {
        let reader = QueryReader::<K, _>::new(name(file), io::stdin().lock(), rounding);
        Box::new(reader.with_seventh(seventh))
    } else {
        exact_ccd_data::open(file, rounding, seventh)?
    };
    Ok(Box::new(records.map(|record| record.map_err(Failure::from))))
}

/// Writes queries to a file, which is replaced; - is standard output.
pub(crate) fn write<K: Kind>(
    file: &Path,
    seventh: Seventh,
    records: impl Iterator<Item = Result<Record<K>, Failure>>,
) -> Result<(), Failure> {
    if is_dash(file) {
        let mut output = io::stdout();
        let written = write_rows(&mut output, seventh, records, Failure::from);
        return written
            .and_then(|()| output.flush().map_err(Failure::from))
            .or_else(Failure::unless_closed_pipe);
    }
    let failed = |source| Failure::write(file, source);
    replace_file(file, |writer| {
        if is_parquet(file) {
            let mut records = records;
            let mut columns = ColumnWriter::new(writer).map_err(failed)?;
            records.try_for_each(|record| columns.write(record?).map_err(failed))?;
            columns.finish().map(|_| ()).map_err(failed)
        } else {
            write_rows(writer, seventh, records, failed)
        }
    })
}

fn write_rows<K: Kind>(
    writer: &mut impl Write,
    seventh: Seventh,
    mut records: impl Iterator<Item = Result<Record<K>, Failure>>,
    failed: impl Fn(io::Error) -> Failure,
) -> Result<(), Failure> {
    let mut writer = BufWriter::new(writer);
    let mut rows = QueryWriter::new(&mut writer, seventh);
    records.try_for_each(|record| rows.write(&record?).map_err(&failed))?;
    writer.flush().map_err(failed)
}

/// The failure of a query by its number in the file, from 0.
pub(crate) fn failed(file: &Path, query: usize, source: RoundingError) -> Failure {
    Failure::new(format_args!("{}, query {query}: {source}", name(file).display()))
}

/// The name of the file in errors.
pub(crate) fn name(file: &Path) -> &Path {
    if is_dash(file) {
        Path::new("standard input")
    } else {
        file
    }
}
