//! Files as bytes, with errors that name the file.

use std::path::Path;

use crate::error::{ParseError, ReadError};

/// Reads a whole file and parses its contents.
pub(super) fn parse_file<T>(
    path: &Path,
    parse: impl FnOnce(&[u8]) -> Result<T, ParseError>,
) -> Result<T, ReadError> {
    let bytes = std::fs::read(path).map_err(|source| ReadError::Io {
        path: path.to_owned(),
        source,
    })?;
    parse(&bytes).map_err(|source| ReadError::Parse {
        path: path.to_owned(),
        source,
    })
}
