//! Query files, and queries on standard input.

use std::io;
use std::path::Path;

use ccd_bench::{DataError, DataKind, QueryReader, Rounding, Sample};

/// Queries as they come out of a file.
pub(crate) type Samples<K> = Box<dyn Iterator<Item = Result<Sample<K>, DataError>>>;

/// The queries in a file; - is standard input.
pub(crate) fn open<K: DataKind + 'static>(file: &Path, rounding: Rounding) -> Result<Samples<K>, DataError> {
    Ok(if is_standard_input(file) {
        Box::new(QueryReader::new(name(file), io::stdin().lock(), rounding))
    } else {
        Box::new(QueryReader::open(file, rounding)?)
    })
}

/// What errors call the file.
pub(crate) fn name(file: &Path) -> &Path {
    if is_standard_input(file) {
        Path::new("standard input")
    } else {
        file
    }
}

fn is_standard_input(file: &Path) -> bool {
    file == Path::new("-")
}
