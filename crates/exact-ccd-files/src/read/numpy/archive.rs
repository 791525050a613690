//! The arrays in a `.npz` archive.

use std::fmt;
use std::io::{Cursor, Read};

use zip::ZipArchive;

use super::super::compressed::Budget;
use super::array::Array;
use super::header::Header;
use crate::error::{Fault, ParseError, Place, quoted};

/// A header takes 128 bytes or a few more.
const LONGEST_HEADER: u64 = 4096;

/// An archive, and the headers of its arrays.
pub(super) struct Archive<'a> {
    zip: ZipArchive<Cursor<&'a [u8]>>,
    budget: Budget,
    pub(super) arrays: Vec<Entry>,
}

/// An array in an archive.
pub(super) struct Entry {
    /// The index in the archive.
    index: usize,
    /// The name without `.npy`.
    pub(super) name: String,
    /// The type and the shape; an error for an array of texts or of other types without a reader.
    pub(super) header: Result<Header, ParseError>,
}

/// The name, the type and the shape, as `` `x` <f4 (2, 10, 3) ``.
impl fmt::Display for Entry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = quoted(self.name.as_bytes());
        match &self.header {
            Ok(header) => write!(f, "{name} {header}"),
            Err(_) => write!(f, "{name} (not an array of numbers)"),
        }
    }
}

impl<'a> Archive<'a> {
    pub(super) fn open(bytes: &'a [u8]) -> Result<Self, ParseError> {
        let invalid = |error: zip::result::ZipError| {
            Fault::expected("a zip archive", quoted(error.to_string().as_bytes())).at(Place::File)
        };
        let mut zip = ZipArchive::new(Cursor::new(bytes)).map_err(invalid)?;
        let mut arrays = Vec::new();
        for index in 0..zip.len() {
            let mut beginning = Vec::new();
            let entry = zip.by_index(index).map_err(invalid)?;
            let name = entry.name().map_err(invalid)?.into_owned();
            let Some(name) = name.strip_suffix(".npy").map(str::to_owned) else {
                continue;
            };
            let read = entry.take(LONGEST_HEADER).read_to_end(&mut beginning);
            read.map_err(|error| invalid(error.into()))?;
            let header = Header::read(&beginning);
            arrays.push(Entry { index, name, header });
        }
        Ok(Self {
            zip,
            budget: Budget::of(bytes.len()),
            arrays,
        })
    }

    /// Reads an array of the archive.
    pub(super) fn read(&mut self, number: usize) -> Result<Array, ParseError> {
        let at_file = |fault: Fault| fault.at(Place::File);
        let entry = self.zip.by_index(self.arrays[number].index).map_err(|error| {
            at_file(Fault::expected(
                "a zip archive",
                quoted(error.to_string().as_bytes()),
            ))
        })?;
        let file = self.budget.read_all(entry, "zip").map_err(at_file)?;
        Array::read(&file)
    }
}

/// Arrays with their types and shapes, for messages.
pub(super) fn list<'e>(entries: impl IntoIterator<Item = &'e Entry>) -> String {
    const MOST: usize = 6;
    let mut entries = entries.into_iter();
    let mut list: Vec<String> = entries.by_ref().take(MOST).map(Entry::to_string).collect();
    match (entries.count(), list.is_empty()) {
        (_, true) => return "no arrays".to_owned(),
        (0, _) => {}
        (more, _) => list.push(format!("{more} more")),
    }
    list.join(", ")
}
