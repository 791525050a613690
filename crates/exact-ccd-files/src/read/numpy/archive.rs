//! The arrays in a `.npz` archive.

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
    /// The index in the archive, the name without `.npy`, and the header of each array.
    pub(super) arrays: Vec<(usize, String, Header)>,
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
            // An array of texts or of other types is of no use.
            if let Ok(header) = Header::read(&beginning) {
                arrays.push((index, name, header));
            }
        }
        Ok(Self {
            zip,
            budget: Budget::of(bytes.len()),
            arrays,
        })
    }

    /// Reads the array at an index in the archive.
    pub(super) fn read(&mut self, index: usize) -> Result<Array, ParseError> {
        let at_file = |fault: Fault| fault.at(Place::File);
        let entry = self.zip.by_index(index).map_err(|error| {
            at_file(Fault::expected(
                "a zip archive",
                quoted(error.to_string().as_bytes()),
            ))
        })?;
        let file = self.budget.read_all(entry, "zip").map_err(at_file)?;
        Array::read(&file)
    }

    /// All arrays with their types and shapes, for messages.
    pub(super) fn describe(&self) -> String {
        const MOST: usize = 6;
        let shown = self.arrays.iter().take(MOST);
        let mut list: Vec<String> = shown
            .map(|(_, name, header)| format!("{} {header}", quoted(name.as_bytes())))
            .collect();
        if self.arrays.len() > MOST {
            list.push(format!("{} more", self.arrays.len() - MOST));
        }
        if list.is_empty() {
            "no arrays of numbers".to_owned()
        } else {
            list.join(", ")
        }
    }
}
