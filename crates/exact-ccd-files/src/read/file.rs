//! Files as bytes, with errors that name the file.

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::budget::Budget;
use super::compressed::gunzip;
use crate::error::{ParseError, Place, ReadError};
use crate::format::{Format, is_gzip};
use crate::unsupported::Unsupported;

/// Reads a whole file of at most `max_size` bytes, and parses its contents. A file whose name ends in `.gz`
/// is decompressed.
pub(super) fn parse_file<T>(
    path: &Path,
    max_size: u64,
    parse: impl FnOnce(&[u8], &Budget) -> Result<T, ParseError>,
) -> Result<T, ReadError> {
    let budget = Budget::new(max_size);
    let bytes = read_within(path, &budget).map_err(|source| ReadError::Io {
        path: path.to_owned(),
        source,
    })?;
    let size = budget.add_file(bytes.len() as u64);
    let contents = size.map_err(|fault| fault.at(Place::File)).and_then(|()| {
        if is_gzip(path) {
            gunzip(&bytes, &budget).map(Cow::Owned)
        } else {
            Ok(Cow::Borrowed(&*bytes))
        }
    });
    contents
        .and_then(|contents| parse(&contents, &budget))
        .map_err(|source| ReadError::Parse {
            path: path.to_owned(),
            source,
        })
}

/// Parses the contents of a file, of at most `max_size` bytes.
pub(super) fn parse_bytes<T>(
    bytes: &[u8],
    max_size: u64,
    parse: impl FnOnce(&[u8], &Budget) -> Result<T, ParseError>,
) -> Result<T, ParseError> {
    let budget = Budget::new(max_size);
    let size = budget.add_file(bytes.len() as u64);
    size.map_err(|fault| fault.at(Place::File))?;
    parse(bytes, &budget)
}

/// The contents of a file, up to one byte more than the budget allows.
pub(super) fn read_within(path: &Path, budget: &Budget) -> io::Result<Vec<u8>> {
    let file = File::open(path)?;
    let most = budget.size_left().saturating_add(1);
    let size = file.metadata()?.len().min(most);
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(usize::try_from(size).unwrap_or(usize::MAX))?;
    file.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
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
