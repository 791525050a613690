//! A check of the metadata at the end of a file, before the library reads them.
//!
//! The library builds the tree of columns by recursion, and reserves memory for as many children as a group
//! announces. Here, the elements are the nodes of one tree of small depth, and everything lies in the file.
//!
//! Apache Parquet, *File Format* and `parquet.thrift`; Apache Thrift, *Compact Protocol Encoding*.

use parquet::errors::{ParquetError, Result};
use parquet::file::reader::{ChunkReader, Length};

use super::guard::GuardedFile;

/// The most levels of groups within groups, and of values within values.
const DEPTH: usize = 32;
/// The length of the metadata and the mark `PAR1` at the end.
const END: u64 = 8;

/// Checks the metadata of a file.
///
/// # Errors
/// If the file cannot be read, or its metadata are not as stated above.
pub(super) fn check(file: &GuardedFile) -> Result<()> {
    let wrong = |problem: &str| Err(ParquetError::General(problem.to_owned()));
    let Some(start) = file.len().checked_sub(END) else {
        return wrong("the file is too short for metadata");
    };
    let end = file.get_bytes(start, END as usize)?;
    let Some((&length, b"PAR1")) = end.split_first_chunk::<4>() else {
        return wrong("the file does not end in PAR1");
    };
    let length = u32::from_le_bytes(length);
    let Some(start) = start.checked_sub(length.into()) else {
        return wrong("the metadata are longer than the file");
    };
    let metadata = file.get_bytes(start, length as usize)?;
    let mut schema = None;
    let read = Thrift { rest: &metadata }.fields(&mut |thrift, field, kind| match (field, kind) {
        (2, LIST) => {
            schema = Some(thrift.schema()?);
            Some(())
        }
        _ => thrift.skip(kind, DEPTH),
    });
    match (read, schema) {
        (Some(()), Some(children)) if is_tree(&children) => Ok(()),
        (Some(()), Some(_)) => wrong("the columns are not one tree of few levels"),
        _ => wrong("the metadata are damaged"),
    }
}

/// Returns true if these are the numbers of children of the nodes of a tree, each before its children,
/// without many levels.
fn is_tree(children: &[usize]) -> bool {
    // The numbers of children that are still to come, of the nodes above.
    let mut open = vec![1_usize];
    for &count in children {
        while open.last() == Some(&0) {
            open.pop();
        }
        let Some(left) = open.last_mut() else {
            return false;
        };
        *left -= 1;
        if open.len() > DEPTH {
            return false;
        }
        open.push(count);
    }
    children.first().is_some_and(|&count| count > 0) && open.iter().all(|&left| left == 0)
}

/// Types of values.
const TRUE: u8 = 1;
const FALSE: u8 = 2;
const BYTE: u8 = 3;
const I32: u8 = 5;
const I64: u8 = 6;
const DOUBLE: u8 = 7;
const BINARY: u8 = 8;
const LIST: u8 = 9;
const SET: u8 = 10;
const MAP: u8 = 11;
const STRUCT: u8 = 12;

/// Values that have not been read. Every function returns `None` if they are not valid.
struct Thrift<'a> {
    rest: &'a [u8],
}

impl Thrift<'_> {
    fn byte(&mut self) -> Option<u8> {
        self.rest.split_off_first().copied()
    }

    fn bytes(&mut self, count: u64) -> Option<()> {
        self.rest.split_off(..usize::try_from(count).ok()?).map(drop)
    }

    /// A number in groups of seven bits, the lowest first.
    fn varint(&mut self) -> Option<u64> {
        let mut number = 0;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            number |= u64::from(byte & 0x7f) << shift;
            if byte & 0x80 == 0 {
                return Some(number);
            }
        }
        None
    }

    fn signed(&mut self) -> Option<i64> {
        let zigzag = self.varint()?;
        Some((zigzag >> 1) as i64 ^ -((zigzag & 1) as i64))
    }

    /// The fields of a structure, by their numbers and types.
    fn fields(&mut self, read: &mut dyn FnMut(&mut Self, i64, u8) -> Option<()>) -> Option<()> {
        let mut field = 0_i64;
        loop {
            let header = self.byte()?;
            let (step, kind) = (header >> 4, header & 15);
            if header == 0 {
                return Some(());
            }
            field = match step {
                0 => self.signed()?,
                _ => field.checked_add(step.into())?,
            };
            read(self, field, kind)?;
        }
    }

    /// The number of elements of a list, each of which takes a byte at least, and their type.
    fn list(&mut self) -> Option<(usize, u8)> {
        let header = self.byte()?;
        let count = match header >> 4 {
            15 => self.varint()?,
            count => count.into(),
        };
        let count = usize::try_from(count).ok()?;
        (count <= self.rest.len()).then_some((count, header & 15))
    }

    fn skip(&mut self, kind: u8, depth: usize) -> Option<()> {
        let depth = depth.checked_sub(1)?;
        match kind {
            TRUE | FALSE => Some(()),
            BYTE => self.bytes(1),
            4..=I64 => self.varint().map(drop),
            DOUBLE => self.bytes(8),
            BINARY => {
                let length = self.varint()?;
                self.bytes(length)
            }
            LIST | SET => {
                let (count, kind) = self.list()?;
                (0..count).try_for_each(|_| self.element(kind, depth))
            }
            MAP => {
                let count = self.varint()?;
                if count == 0 {
                    return Some(());
                }
                let kinds = self.byte()?;
                (0..count).try_for_each(|_| {
                    self.element(kinds >> 4, depth)?;
                    self.element(kinds & 15, depth)
                })
            }
            STRUCT => self.fields(&mut |thrift, _, kind| thrift.skip(kind, depth)),
            _ => None,
        }
    }

    /// Skips an element of a list or of a map, where a truth value takes a byte.
    fn element(&mut self, kind: u8, depth: usize) -> Option<()> {
        match kind {
            TRUE | FALSE => self.bytes(1),
            _ => self.skip(kind, depth),
        }
    }

    /// The number of children of each element of the schema.
    fn schema(&mut self) -> Option<Vec<usize>> {
        let (count, kind) = self.list()?;
        if kind != STRUCT {
            return None;
        }
        let mut elements = Vec::new();
        for _ in 0..count {
            let (mut children, mut has_type) = (0, false);
            self.fields(&mut |thrift, field, kind| match (field, kind) {
                (5, I32) => {
                    children = usize::try_from(thrift.signed()?).ok()?;
                    Some(())
                }
                _ => {
                    has_type |= field == 1;
                    thrift.skip(kind, DEPTH)
                }
            })?;
            // A column has a type, and a group has children.
            if has_type == (children > 0) {
                return None;
            }
            elements.push(children);
        }
        Some(elements)
    }
}
