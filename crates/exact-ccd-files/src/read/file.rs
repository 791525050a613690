//! Files as bytes, with errors that name the file.

use std::borrow::Cow;
use std::path::Path;

use super::compressed::gunzip;
use crate::error::{ParseError, ReadError};
use crate::format::{Format, is_gzip};
use crate::unsupported::Unsupported;

/// Reads a whole file and parses its contents. A file whose name ends in `.gz` is decompressed.
pub(super) fn parse_file<T>(
    path: &Path,
    parse: impl FnOnce(&[u8]) -> Result<T, ParseError>,
) -> Result<T, ReadError> {
    let bytes = std::fs::read(path).map_err(|source| ReadError::Io {
        path: path.to_owned(),
        source,
    })?;
    let contents = if is_gzip(path) {
        gunzip(&bytes).map(Cow::Owned)
    } else {
        Ok(Cow::Borrowed(&*bytes))
    };
    contents
        .and_then(|contents| parse(&contents))
        .map_err(|source| ReadError::Parse {
            path: path.to_owned(),
            source,
        })
}

/// The format that belongs to the extension of a path.
pub(super) fn format_of(path: &Path) -> Result<Format, ReadError> {
    let path_buf = || path.to_owned();
    Format::of_path(path).ok_or_else(|| match Unsupported::of_path(path) {
        Some(format) => ReadError::Unsupported {
            path: path_buf(),
            format,
        },
        None => ReadError::Extension { path: path_buf() },
    })
}
