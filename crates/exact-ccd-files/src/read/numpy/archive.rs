//! The arrays in a `.npz` archive.

use std::fmt;

use super::super::budget::Budget;
use super::super::zip::Zip;
use super::array::Array;
use super::header::Header;
use crate::error::{Fault, ParseError, Place, quoted};

/// A header takes 128 bytes or a few more.
const LONGEST_HEADER: u64 = 4096;

/// An archive, and the headers of its arrays.
pub(super) struct Archive<'a> {
    zip: Zip<'a>,
    budget: &'a Budget,
    pub(super) arrays: Vec<Entry>,
}

/// An array in an archive.
pub(super) struct Entry {
    /// The number of the member of the archive.
    member: usize,
    /// The name without `.npy`.
    pub(super) name: String,
    /// The type and the shape; an error for an array without a reader, and for a member that cannot be read.
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
    pub(super) fn open(bytes: &'a [u8], budget: &'a Budget) -> Result<Self, ParseError> {
        let mut zip = Zip::open(bytes, budget)?;
        let mut arrays = Vec::new();
        for (member, name) in zip.names().into_iter().enumerate() {
            let Some(name) = name.strip_suffix(".npy") else {
                continue;
            };
            let header = match zip.beginning(member, LONGEST_HEADER) {
                Ok(beginning) => {
                    budget.work(beginning.len() as u64).map_err(at_file)?;
                    Header::read(&beginning, budget)
                }
                Err(error) if matches!(error.fault, Fault::Expansion { .. }) => return Err(error),
                Err(error) => Err(error),
            };
            let name = name.to_owned();
            arrays.push(Entry { member, name, header });
        }
        budget.hold::<Entry>(arrays.len());
        Ok(Self { zip, budget, arrays })
    }

    /// Reads an array of the archive.
    pub(super) fn read(&mut self, number: usize) -> Result<Array, ParseError> {
        Array::read(&self.zip.read(self.arrays[number].member)?, self.budget)
    }
}

fn at_file(fault: Fault) -> ParseError {
    fault.at(Place::File)
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
