//! The kind of queries in files, where it is certain.

use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};

use exact_ccd::{AnyKind, Kind, with_kind};
use exact_ccd_data::{ColumnReader, DataError, is_parquet};

use crate::files::outputs::is_dash;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;

/// The given kind, or that of all files. A kind that follows from the number of rows is noted: a file that
/// ends too early may have the rows of another one. So is a given kind that is not that of the folder.
pub(crate) fn kind_of(
    given: Option<AnyKind>,
    files: &[PathBuf],
    notes: &mut Notes,
) -> Result<AnyKind, Failure> {
    if let Some(kind) = given {
        note_other_folders(kind, files, notes);
        return Ok(kind);
    }
    let mut found: Option<AnyKind> = None;
    for file in files {
        let kind = of_file(file, notes)?;
        match found {
            Some(other) if other != kind => {
                return Err(Failure::of(
                    file,
                    format_args!(
                        "queries of the kind {}, after others of the kind {}",
                        kind.short(),
                        other.short()
                    ),
                ));
            }
            _ => found = Some(kind),
        }
    }
    found.ok_or_else(|| uncertain(Path::new("")))
}

/// The kind that a Parquet file names, that of the folder as in the published data sets, or the only one
/// whose queries fill the rows of the file.
fn of_file(file: &Path, notes: &mut Notes) -> Result<AnyKind, Failure> {
    // A pipe can be read only once.
    if is_dash(file) || !file.is_file() {
        return Err(uncertain(file));
    }
    if is_parquet(file) {
        return of_columns(file);
    }
    let rows = row_count(file).map_err(|source| DataError::Io {
        file: file.to_owned(),
        source,
    })?;
    if rows == 0 {
        return Err(no_queries());
    }
    if let Some(kind) = of_folder(file) {
        return Ok(kind);
    }
    let kind = of_count(rows).ok_or_else(|| uncertain(file))?;
    notes.note(format!(
        "{}: {rows} rows are queries of the kind {}; --kind names another",
        file.display(),
        kind.short()
    ));
    Ok(kind)
}

/// Notes the first file in a folder of another kind than the given one.
pub(crate) fn note_other_folders(given: AnyKind, files: &[PathBuf], notes: &mut Notes) {
    let other = files.iter().filter(|file| !is_dash(file)).find_map(|file| {
        let kind = of_folder(file).filter(|kind| *kind != given)?;
        Some((file.display(), kind))
    });
    if let Some((file, kind)) = other {
        notes.note(format!(
            "{file}: read as queries of the kind {} by --kind; the folder is one of the kind {}",
            given.short(),
            kind.short()
        ));
    }
}

fn uncertain(file: &Path) -> Failure {
    let kinds: Vec<&str> = AnyKind::ALL.iter().map(|kind| kind.short()).collect();
    let kinds = kinds.join("|");
    Failure::of(
        file,
        format_args!("the kind of the queries is not certain from the file; --kind {kinds} names it"),
    )
}

/// The failure of an input without a query.
pub(crate) fn no_queries() -> Failure {
    Failure::new("0 queries: the input is empty")
}

fn of_folder(file: &Path) -> Option<AnyKind> {
    let file = std::path::absolute(file).ok()?;
    let folder = file.parent()?.file_name()?;
    AnyKind::ALL.iter().copied().find(|kind| folder == kind.name())
}

/// The kind of the queries in a Parquet file. A damaged file has an error of its own for each kind.
fn of_columns(file: &Path) -> Result<AnyKind, Failure> {
    fn read<K: Kind>(file: &Path) -> Result<bool, DataError> {
        let first = ColumnReader::<K>::open(file)?.next().transpose()?;
        Ok(first.is_some())
    }
    let read = |&kind: &AnyKind| (kind, with_kind!(kind, K => read::<K>(file)));
    let kinds: Vec<_> = AnyKind::ALL.iter().map(read).collect();
    if let Some((kind, _)) = kinds.iter().find(|(_, read)| matches!(read, Ok(true))) {
        return Ok(*kind);
    }
    let errors: Vec<DataError> = kinds.into_iter().filter_map(|(_, read)| read.err()).collect();
    // A query of another kind is an error of its row.
    let is_of_file = |error: &DataError| !matches!(error, DataError::Record { .. });
    let is_of_all = errors.len() == AnyKind::ALL.len() && errors.iter().all(is_of_file);
    match errors.into_iter().next() {
        None => Err(no_queries()),
        Some(first) if is_of_all => Err(first.into()),
        Some(_) => Err(uncertain(file)),
    }
}

/// The only kind whose queries, two rows for each point, fill this many rows.
fn of_count(rows: usize) -> Option<AnyKind> {
    let fills = |kind: &AnyKind| rows.is_multiple_of(2 * kind.point_names().len());
    let mut kinds = AnyKind::ALL.iter().copied().filter(fills);
    let first = kinds.next();
    first.filter(|_| kinds.next().is_none())
}

/// The number of lines that are not blank.
fn row_count(file: &Path) -> io::Result<usize> {
    let mut reader = BufReader::new(File::open(file)?);
    let (mut line, mut rows) = (Vec::new(), 0);
    while reader.read_until(b'\n', &mut line)? > 0 {
        rows += usize::from(!line.trim_ascii().is_empty());
        line.clear();
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_kind_follows_from_a_count_if_no_other_one_fits() {
        for (rows, kind) in [
            (4, Some(AnyKind::VertexVertex)),
            (6, Some(AnyKind::VertexEdge)),
            (18, Some(AnyKind::VertexEdge)),
            (20, Some(AnyKind::VertexVertex)),
            (0, None),
            (8, None),
            (12, None),
            (24, None),
            (5, None),
        ] {
            assert_eq!(of_count(rows), kind, "{rows}");
        }
    }
}
