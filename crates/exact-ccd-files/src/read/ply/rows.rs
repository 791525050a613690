//! The values in the rows of a PLY file, from text or from binary data.

use super::super::binary::{ByteOrder, Bytes};
use super::super::text::{Line, Lines};
use super::header::{Element, Integer, Scalar};
use crate::error::{ParseError, Place, quoted};

/// A reader of rows, one after the other, value by value.
pub(super) trait Rows<'a> {
    /// Moves to the beginning of a row.
    fn begin(&mut self, row: Row<'a>) -> Result<(), ParseError>;

    fn number(&mut self, scalar: Scalar) -> Result<f64, ParseError>;

    fn integer(&mut self, integer: Integer) -> Result<i64, ParseError>;

    fn skip(&mut self, scalar: Scalar, count: u64) -> Result<(), ParseError>;

    /// Checks that the whole row has been read.
    fn end(&mut self) -> Result<(), ParseError>;

    /// Checks that nothing follows.
    fn finish(&mut self) -> Result<(), ParseError>;

    fn place(&self) -> Place;
}

/// A row: its element and its number, from 0.
#[derive(Clone, Copy)]
pub(super) struct Row<'a> {
    pub(super) element: &'a Element<'a>,
    pub(super) number: u64,
}

impl Row<'_> {
    fn describe(&self) -> String {
        let Element { name, count, .. } = self.element;
        format!("row {} of the {count} of element {}", self.number, quoted(name))
    }
}

/// Rows as text, one on each line. Numbers are read to the nearest `f64`, whatever their type in
/// the header.
pub(super) struct TextRows<'a> {
    lines: Lines<'a>,
    line: Line<'a>,
}

impl<'a> TextRows<'a> {
    pub(super) fn new(lines: Lines<'a>) -> Self {
        let line = Line::default();
        Self { lines, line }
    }
}

impl<'a> Rows<'a> for TextRows<'a> {
    fn begin(&mut self, row: Row<'a>) -> Result<(), ParseError> {
        self.line = self.lines.expect(|| row.describe())?;
        Ok(())
    }

    fn number(&mut self, _: Scalar) -> Result<f64, ParseError> {
        self.line.coordinate()
    }

    fn integer(&mut self, _: Integer) -> Result<i64, ParseError> {
        self.line.integer("an integer")
    }

    fn skip(&mut self, _: Scalar, count: u64) -> Result<(), ParseError> {
        (0..count).try_for_each(|_| self.line.expect_word("a number").map(drop))
    }

    fn end(&mut self) -> Result<(), ParseError> {
        self.line.expect_end()
    }

    fn finish(&mut self) -> Result<(), ParseError> {
        self.lines.expect_end()
    }

    fn place(&self) -> Place {
        self.line.place()
    }
}

/// Rows as binary data, without gaps.
pub(super) struct BinaryRows<'a> {
    bytes: Bytes<'a>,
    order: ByteOrder,
    row: Option<Row<'a>>,
}

impl<'a> BinaryRows<'a> {
    pub(super) fn new(bytes: Bytes<'a>, order: ByteOrder) -> Self {
        let row = None;
        Self { bytes, order, row }
    }

    /// The bytes of the next value, the least significant first.
    fn value<const N: usize>(&mut self) -> Result<[u8; N], ParseError> {
        let row = self.row;
        self.bytes.number(self.order, || expected(row))
    }
}

fn expected(row: Option<Row>) -> String {
    row.map_or_else(String::new, |row| row.describe())
}

impl<'a> Rows<'a> for BinaryRows<'a> {
    fn begin(&mut self, row: Row<'a>) -> Result<(), ParseError> {
        self.row = Some(row);
        Ok(())
    }

    fn number(&mut self, scalar: Scalar) -> Result<f64, ParseError> {
        Ok(match scalar {
            Scalar::Float32 => f64::from(f32::from_le_bytes(self.value()?)),
            Scalar::Float64 => f64::from_le_bytes(self.value()?),
            // Exact: the integer has at most 32 bits.
            Scalar::Integer(integer) => self.integer(integer)? as f64,
        })
    }

    fn integer(&mut self, integer: Integer) -> Result<i64, ParseError> {
        Ok(match integer {
            Integer::I8 => i8::from_le_bytes(self.value()?).into(),
            Integer::U8 => u8::from_le_bytes(self.value()?).into(),
            Integer::I16 => i16::from_le_bytes(self.value()?).into(),
            Integer::U16 => u16::from_le_bytes(self.value()?).into(),
            Integer::I32 => i32::from_le_bytes(self.value()?).into(),
            Integer::U32 => u32::from_le_bytes(self.value()?).into(),
        })
    }

    fn skip(&mut self, scalar: Scalar, count: u64) -> Result<(), ParseError> {
        let row = self.row;
        let length = count.saturating_mul(scalar.size());
        self.bytes.take(length, || expected(row)).map(drop)
    }

    fn end(&mut self) -> Result<(), ParseError> {
        Ok(())
    }

    fn finish(&mut self) -> Result<(), ParseError> {
        self.bytes.expect_end()
    }

    fn place(&self) -> Place {
        self.bytes.place()
    }
}
