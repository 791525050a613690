//! The values in a Gmsh file, from text or from binary data.

use std::fmt;

use super::super::binary::{ByteOrder, Bytes};
use super::super::text::{Line, Lines, expect, parse};
use crate::error::{Fault, ParseError, Place, quoted};

/// The version of the format.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Version {
    V2,
    V4,
}

/// Values that belong together: in text, one line.
#[derive(Clone, Copy)]
pub(super) struct Record {
    name: &'static str,
    /// Its number, from 0, and the count of such records.
    number: Option<(u64, u64)>,
}

impl Record {
    pub(super) fn one(name: &'static str) -> Self {
        let number = None;
        Self { name, number }
    }

    pub(super) fn of(name: &'static str, number: u64, count: u64) -> Self {
        let number = Some((number, count));
        Self { name, number }
    }
}

impl fmt::Display for Record {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.number {
            None => f.write_str(self.name),
            Some((number, count)) => write!(f, "{} {number} of {count}", self.name),
        }
    }
}

/// A reader of values, one after the other. `expected` describes a value in errors.
pub(super) trait Values<'a> {
    /// True for binary files, where elements of version 2 come in blocks.
    const BINARY: bool;

    /// The place and the name of the next section, or none at the end of the file.
    fn section(&mut self) -> Option<(Place, &'a [u8])>;

    /// Skips everything up to and including a line that begins with this word.
    fn skip_to(&mut self, end: &str) -> Result<(), ParseError>;

    /// Checks that the next line consists of this word.
    fn end_section(&mut self, end: &str) -> Result<(), ParseError>;

    /// A count on a line of its own, which is text even in a binary file.
    fn count_line(&mut self, expected: &'static str) -> Result<u64, ParseError>;

    /// A line with its place, which is text even in a binary file.
    fn line(&mut self, expected: &str) -> Result<(Place, &'a [u8]), ParseError>;

    /// Moves to the beginning of a record.
    fn begin(&mut self, record: Record) -> Result<(), ParseError>;

    /// A whole number of four bytes.
    fn int(&mut self, expected: &str) -> Result<i64, ParseError>;

    /// A whole number of eight bytes, not negative.
    fn size(&mut self, expected: &str) -> Result<u64, ParseError>;

    fn real(&mut self, expected: &str) -> Result<f64, ParseError>;

    /// Checks that the whole record has been read.
    fn end(&mut self) -> Result<(), ParseError>;

    fn place(&self) -> Place;
}

pub(super) struct TextValues<'a> {
    lines: Lines<'a>,
    line: Line<'a>,
}

impl<'a> TextValues<'a> {
    pub(super) fn new(lines: Lines<'a>) -> Self {
        let line = Line::default();
        Self { lines, line }
    }
}

impl<'a> Values<'a> for TextValues<'a> {
    const BINARY: bool = false;

    fn section(&mut self) -> Option<(Place, &'a [u8])> {
        let Some(line) = self.lines.next() else {
            // An empty line makes `place` return the end of the file.
            self.line = Line::default();
            return None;
        };
        self.line = line;
        Some((self.line.place(), self.line.word()?))
    }

    fn skip_to(&mut self, end: &str) -> Result<(), ParseError> {
        loop {
            let mut line = self.lines.expect(|| quoted(end.as_bytes()))?;
            if line.word() == Some(end.as_bytes()) {
                return line.expect_end();
            }
        }
    }

    fn end_section(&mut self, end: &str) -> Result<(), ParseError> {
        let mut line = self.lines.expect(|| quoted(end.as_bytes()))?;
        expect(&mut line, end)?;
        line.expect_end()
    }

    fn count_line(&mut self, expected: &'static str) -> Result<u64, ParseError> {
        self.begin(Record::one(expected))?;
        let count = self.line.count(expected)?;
        self.end()?;
        Ok(count)
    }

    fn line(&mut self, expected: &str) -> Result<(Place, &'a [u8]), ParseError> {
        let line = self.lines.expect(|| expected.to_owned())?;
        Ok((line.place(), line.rest()))
    }

    fn begin(&mut self, record: Record) -> Result<(), ParseError> {
        self.line = self.lines.expect(|| record.to_string())?;
        Ok(())
    }

    fn int(&mut self, expected: &str) -> Result<i64, ParseError> {
        self.line.integer(expected)
    }

    fn size(&mut self, expected: &str) -> Result<u64, ParseError> {
        self.line.count(expected)
    }

    fn real(&mut self, expected: &str) -> Result<f64, ParseError> {
        self.line.real(expected)
    }

    fn end(&mut self) -> Result<(), ParseError> {
        self.line.expect_end()
    }

    fn place(&self) -> Place {
        match self.line.place() {
            Place::Line(0) => self.lines.end(),
            place => place,
        }
    }
}

pub(super) struct BinaryValues<'a> {
    bytes: Bytes<'a>,
    order: ByteOrder,
    record: Record,
}

impl<'a> BinaryValues<'a> {
    pub(super) fn new(bytes: Bytes<'a>, order: ByteOrder) -> Self {
        let record = Record::one("a section");
        Self { bytes, order, record }
    }

    /// The bytes of the next value, the least significant first.
    fn value<const N: usize>(&mut self, expected: &str) -> Result<[u8; N], ParseError> {
        let record = self.record;
        self.bytes
            .number(self.order, || format!("{expected} in {record}"))
    }
}

impl<'a> Values<'a> for BinaryValues<'a> {
    const BINARY: bool = true;

    fn section(&mut self) -> Option<(Place, &'a [u8])> {
        self.bytes.skip_blank();
        let place = self.bytes.place();
        let line = self.bytes.line();
        (!line.is_empty()).then_some((place, line))
    }

    fn skip_to(&mut self, end: &str) -> Result<(), ParseError> {
        let place = self.bytes.place();
        self.bytes
            .skip_to(end.as_bytes())
            .ok_or_else(|| Fault::ends(quoted(end.as_bytes())).at(place))?;
        self.end_section(end)
    }

    fn end_section(&mut self, end: &str) -> Result<(), ParseError> {
        let expected = quoted(end.as_bytes());
        match self.section() {
            Some((_, line)) if line == end.as_bytes() => Ok(()),
            Some((place, line)) => Err(Fault::expected(expected, quoted(line)).at(place)),
            None => Err(Fault::ends(expected).at(self.place())),
        }
    }

    fn count_line(&mut self, expected: &'static str) -> Result<u64, ParseError> {
        let place = self.place();
        let line = self.bytes.line();
        parse(line).ok_or_else(|| Fault::expected(expected, quoted(line)).at(place))
    }

    fn line(&mut self, expected: &str) -> Result<(Place, &'a [u8]), ParseError> {
        let place = self.place();
        self.section().ok_or_else(|| Fault::ends(expected).at(place))
    }

    fn begin(&mut self, record: Record) -> Result<(), ParseError> {
        self.record = record;
        Ok(())
    }

    fn int(&mut self, expected: &str) -> Result<i64, ParseError> {
        Ok(i32::from_le_bytes(self.value(expected)?).into())
    }

    fn size(&mut self, expected: &str) -> Result<u64, ParseError> {
        Ok(u64::from_le_bytes(self.value(expected)?))
    }

    fn real(&mut self, expected: &str) -> Result<f64, ParseError> {
        Ok(f64::from_le_bytes(self.value(expected)?))
    }

    fn end(&mut self) -> Result<(), ParseError> {
        Ok(())
    }

    fn place(&self) -> Place {
        self.bytes.place()
    }
}
