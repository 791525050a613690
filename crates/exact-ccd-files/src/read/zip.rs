//! Zip archives: the list of members at the end of the file, and the members.
//!
//! PKWARE, *APPNOTE.TXT: .ZIP File Format Specification*. Members are stored or compressed by deflate, which
//! is all that numpy writes.

use std::io::Read;

use flate2::Crc;
use flate2::read::DeflateDecoder;

use super::binary::Bytes;
use super::budget::Budget;
use crate::error::{Fault, ParseError, Place, quoted};

/// The length of the record at the end of an archive, without its comment.
const END: usize = 22;
/// The longest comment.
const COMMENT: usize = 0xffff;
/// The work for a compressed member besides its bytes, in steps: the decompressor has tables to set up.
const MEMBER: u64 = 4096;

/// An archive and the list of its members.
pub(super) struct Zip<'a> {
    file: &'a [u8],
    budget: &'a Budget,
    pub(super) members: Vec<Member>,
}

/// A member of an archive.
pub(super) struct Member {
    pub(super) name: String,
    is_compressed: bool,
    crc: u32,
    compressed_size: u64,
    size: u64,
    /// The offset of the header before its data.
    offset: u64,
}

impl<'a> Zip<'a> {
    pub(super) fn open(file: &'a [u8], budget: &'a Budget) -> Result<Self, ParseError> {
        let (offset, count) = directory(file, budget)?;
        let start = usize::try_from(offset).ok().filter(|&start| start <= file.len());
        let start = start.ok_or_else(|| invalid("a list of members within the file").at(Place::File))?;
        let mut bytes = Bytes::new(file, start, budget);
        let mut members = Vec::new();
        for _ in 0..count {
            members.push(Member::read(&mut bytes)?);
        }
        budget.hold::<Member>(members.len());
        Ok(Self {
            file,
            budget,
            members,
        })
    }

    /// The first bytes of a member, at most this number.
    pub(super) fn beginning(&self, member: &Member, most: u64) -> Result<Vec<u8>, ParseError> {
        let data = self.data(member)?;
        if !member.is_compressed {
            let length = usize::try_from(most).map_or(data.len(), |most| most.min(data.len()));
            return Ok(data[..length].to_vec());
        }
        self.budget.work(MEMBER).map_err(|fault| fault.at(Place::File))?;
        let mut beginning = Vec::new();
        let mut decoder = DeflateDecoder::new(data).take(most);
        let read = decoder.read_to_end(&mut beginning);
        read.map_err(|_| invalid("data compressed by deflate").at(Place::File))?;
        Ok(beginning)
    }

    /// All data of a member.
    pub(super) fn read(&self, member: &Member) -> Result<Vec<u8>, ParseError> {
        let data = self.data(member)?;
        let read = if member.is_compressed {
            let decoder = DeflateDecoder::new(data);
            self.budget.read_all(decoder, "deflate", member.size)
        } else {
            self.budget.take(data.len() as u64).map(|()| data.to_vec())
        };
        let read = read.map_err(|fault| fault.at(Place::File))?;
        let mut crc = Crc::new();
        crc.update(&read);
        if read.len() as u64 != member.size || crc.sum() != member.crc {
            let expected = format!("the data of member {}", quoted(member.name.as_bytes()));
            let found = "data with another size or checksum";
            return Err(Fault::expected(expected, found).at(Place::File));
        }
        Ok(read)
    }

    /// The data of a member as they are in the file.
    fn data(&self, member: &Member) -> Result<&'a [u8], ParseError> {
        let expected = || format!("member {}", quoted(member.name.as_bytes()));
        let start = usize::try_from(member.offset).ok();
        let start = start.filter(|&start| start <= self.file.len());
        let start = start.ok_or_else(|| Fault::ends(expected()).at(Place::File))?;
        let mut bytes = Bytes::new(self.file, start, self.budget);
        signature(&mut bytes, *b"PK\x03\x04")?;
        bytes.take(22, expected)?;
        let [name, extra] = [number(&mut bytes)?, number(&mut bytes)?].map(u64::from);
        bytes.take(name + extra, expected)?;
        let data = bytes.take(member.compressed_size, expected)?;
        // Members may have their data in common, and compressed data need not expand to anything.
        let work = self.budget.work(data.len() as u64);
        work.map_err(|fault| fault.at(Place::File))?;
        Ok(data)
    }
}

impl Member {
    /// The next member in the list.
    fn read(bytes: &mut Bytes) -> Result<Self, ParseError> {
        let expected = || "a member in the list of members".to_owned();
        signature(bytes, *b"PK\x01\x02")?;
        let place = bytes.place();
        bytes.take(4, expected)?;
        let (flags, method) = (number(bytes)?, number(bytes)?);
        bytes.take(4, expected)?;
        let crc = u32::from_le_bytes(bytes.array(expected)?);
        let mut sizes: [u64; 2] = [long(bytes)?, long(bytes)?];
        let lengths = [number(bytes)?, number(bytes)?, number(bytes)?];
        bytes.take(8, expected)?;
        let mut offset = long(bytes)?;
        let [name, extra, comment] = lengths.map(u64::from);
        let name = bytes.take(name, expected)?;
        let extra = bytes.take(extra, expected)?;
        bytes.take(comment, expected)?;
        let mut long_numbers = zip64(extra);
        let [compressed_size, size] = &mut sizes;
        // The order of these numbers in the extra field is that of the specification.
        for number in [size, compressed_size, &mut offset] {
            if *number == u64::from(u32::MAX) {
                *number = long_numbers
                    .next()
                    .ok_or_else(|| invalid("numbers of eight bytes").at(place))?;
            }
        }
        let name = String::from_utf8_lossy(name).into_owned();
        let is_compressed = match (flags & 1, method) {
            (0, 0) => false,
            (0, 8) => true,
            _ => {
                let expected = "members that are stored or compressed by deflate, without a password";
                return Err(Fault::expected(expected, quoted(name.as_bytes())).at(place));
            }
        };
        Ok(Self {
            name,
            is_compressed,
            crc,
            compressed_size: sizes[0],
            size: sizes[1],
            offset,
        })
    }
}

/// The offset of the list of members, and their number.
fn directory(file: &[u8], budget: &Budget) -> Result<(u64, u64), ParseError> {
    let first = file.len().saturating_sub(END + COMMENT);
    let is_end = |&at: &usize| {
        let record = &file[at..];
        let comment = record
            .get(20..END)
            .map_or(0, |length| usize::from(length[0]) | usize::from(length[1]) << 8);
        record.starts_with(b"PK\x05\x06") && record.len() == END + comment
    };
    budget.step((file.len() - first) as u64);
    let at = (first..file.len()).rev().find(is_end);
    let at = at.ok_or_else(|| invalid("its end").at(Place::File))?;
    let mut bytes = Bytes::new(file, at + 10, budget);
    let count = number(&mut bytes)?;
    bytes.take(4, String::new)?;
    let offset = long(&mut bytes)?;
    if count < u16::MAX && offset < u64::from(u32::MAX) {
        return Ok((offset, count.into()));
    }
    // The numbers are in another record. Its place is in a record of 20 bytes before the end.
    let Some(locator) = at
        .checked_sub(20)
        .filter(|&at| file[at..].starts_with(b"PK\x06\x07"))
    else {
        return Ok((offset, count.into()));
    };
    let record = eight(&mut Bytes::new(file, locator + 8, budget))?;
    let record = usize::try_from(record)
        .ok()
        .filter(|&record| record <= file.len());
    let record = record.ok_or_else(|| invalid("its end").at(Place::Byte(locator)))?;
    let mut bytes = Bytes::new(file, record, budget);
    signature(&mut bytes, *b"PK\x06\x06")?;
    bytes.take(28, || "the end of a zip archive".to_owned())?;
    let count = eight(&mut bytes)?;
    eight(&mut bytes)?;
    Ok((eight(&mut bytes)?, count))
}

/// The numbers of eight bytes in the extra field of a member.
fn zip64(extra: &[u8]) -> impl Iterator<Item = u64> {
    let mut rest = extra;
    let mut field = std::iter::from_fn(move || {
        let (&[a, b, c, d], after) = rest.split_first_chunk()?;
        let data = after.get(..usize::from(u16::from_le_bytes([c, d])))?;
        rest = &after[data.len()..];
        Some((u16::from_le_bytes([a, b]), data))
    });
    let data = field.find(|(tag, _)| *tag == 1).map_or(&[][..], |(_, data)| data);
    data.as_chunks::<8>()
        .0
        .iter()
        .map(|&number| u64::from_le_bytes(number))
}

fn signature(bytes: &mut Bytes, expected: [u8; 4]) -> Result<(), ParseError> {
    let place = bytes.place();
    let found: [u8; 4] = bytes.array(|| "a zip archive".to_owned())?;
    if found == expected {
        return Ok(());
    }
    let expected = format!("a record `{}` of a zip archive", expected.escape_ascii());
    Err(Fault::expected(expected, quoted(&found)).at(place))
}

fn number(bytes: &mut Bytes) -> Result<u16, ParseError> {
    Ok(u16::from_le_bytes(
        bytes.array(|| "a number of two bytes".to_owned())?,
    ))
}

fn long(bytes: &mut Bytes) -> Result<u64, ParseError> {
    let number = bytes.array(|| "a number of four bytes".to_owned())?;
    Ok(u32::from_le_bytes(number).into())
}

fn eight(bytes: &mut Bytes) -> Result<u64, ParseError> {
    Ok(u64::from_le_bytes(
        bytes.array(|| "a number of eight bytes".to_owned())?,
    ))
}

fn invalid(missing: &str) -> Fault {
    Fault::expected("a zip archive", format!("none: {missing} is missing or wrong"))
}
