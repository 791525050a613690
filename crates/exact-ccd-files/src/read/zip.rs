//! Zip archives, whose reading is counted.

use std::io::{self, Cursor, Read, Seek, SeekFrom};

use ::zip::ZipArchive;
use ::zip::read::ZipFile;
use ::zip::result::ZipError;

use super::budget::Budget;
use crate::error::{Fault, ParseError, Place, quoted};

/// The work for a member besides its bytes, in steps: the decompressor has tables to set up.
const MEMBER: u64 = 4096;
/// The memory of the library for each byte of the list of members, at most: a member takes 46 bytes and its
/// name in the file, and an extra field of a member four.
const BYTES_A_BYTE: usize = 16;

/// An archive. Members that are not read may be of any kind.
pub(super) struct Zip<'a> {
    archive: ZipArchive<Counted<'a>>,
    budget: &'a Budget,
}

impl<'a> Zip<'a> {
    pub(super) fn open(file: &'a [u8], budget: &'a Budget) -> Result<Self, ParseError> {
        let bytes = Cursor::new(file);
        let archive = ZipArchive::new(Counted { bytes, budget });
        let archive = archive.map_err(|error| wrong("a zip archive", error).at(Place::File))?;
        if archive.has_duplicate_names() {
            let expected = "members with names of their own in a zip archive";
            return Err(Fault::expected(expected, "the same name twice").at(Place::File));
        }
        let list = (file.len() as u64).saturating_sub(archive.central_directory_start());
        budget.hold::<[u8; BYTES_A_BYTE]>(list as usize);
        Ok(Self { archive, budget })
    }

    /// The name of each member.
    pub(super) fn names(&self) -> Vec<String> {
        let names = self.archive.file_names_raw();
        names
            .map(|name| String::from_utf8_lossy(name).into_owned())
            .collect()
    }

    /// The first bytes of a member, at most this number.
    pub(super) fn beginning(&mut self, member: usize, most: u64) -> Result<Vec<u8>, ParseError> {
        self.with(member, |member, expected, _| {
            let mut beginning = Vec::new();
            let read = member.take(most).read_to_end(&mut beginning);
            read.map_err(|error| Fault::of_io(expected, &error))?;
            Ok(beginning)
        })
    }

    /// All data of a member.
    pub(super) fn read(&mut self, member: usize) -> Result<Vec<u8>, ParseError> {
        self.with(member, |member, expected, budget| {
            let size = member.size();
            let data = budget.read_all(member, expected, size)?;
            match data.len() as u64 == size {
                true => Ok(data),
                false => Err(Fault::expected(expected, "data of another size")),
            }
        })
    }

    fn with<T>(
        &mut self,
        member: usize,
        read: impl FnOnce(ZipFile<'_, Counted<'a>>, &str, &Budget) -> Result<T, Fault>,
    ) -> Result<T, ParseError> {
        let name = self.archive.file_names_raw().nth(member).unwrap_or_default();
        let expected = format!("member {}, stored or compressed by deflate", quoted(name));
        let opened = self.budget.work(MEMBER).and_then(|()| {
            let opened = self.archive.by_index(member);
            opened.map_err(|error| wrong(&expected, error))
        });
        let data = opened.and_then(|opened| read(opened, &expected, self.budget));
        data.map_err(|fault| fault.at(Place::File))
    }
}

/// The bytes of an archive. The library may read some of them several times, and members may have their
/// data in common: reading is work.
struct Counted<'a> {
    bytes: Cursor<&'a [u8]>,
    budget: &'a Budget,
}

impl Read for Counted<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.bytes.read(buffer)?;
        self.budget.work(count as u64).map_err(io::Error::other)?;
        Ok(count)
    }
}

impl Seek for Counted<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.budget.work(1).map_err(io::Error::other)?;
        self.bytes.seek(to)
    }
}

/// The error of the library, or the one of the budget.
fn wrong(expected: &str, error: ZipError) -> Fault {
    match error {
        ZipError::Io(error) => Fault::of_io(expected, &error),
        error => Fault::expected(expected, quoted(error.to_string().as_bytes())),
    }
}
