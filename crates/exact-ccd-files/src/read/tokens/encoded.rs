//! Numbers in the encoding of a file. `expected` describes a number in errors.

use super::super::record::Record;
use super::super::scalar::Scalar;
use super::{Encoding, Number, Tokens};
use crate::error::ParseError;

impl<'a> Tokens<'a> {
    /// Moves to the beginning of a record: in text, to its line.
    pub(in super::super) fn begin(&mut self, record: Record<'a>) -> Result<(), ParseError> {
        self.record = record;
        match self.encoding {
            Encoding::Text => self.expect_line(|| record.to_string()),
            Encoding::Binary(_) => {
                self.token = self.offset();
                Ok(())
            }
        }
    }

    /// Checks that the whole record has been read.
    pub(in super::super) fn end(&self) -> Result<(), ParseError> {
        match self.encoding {
            Encoding::Text => self.expect_line_end(),
            Encoding::Binary(_) => Ok(()),
        }
    }

    /// The nearest `f64`, whatever the type in text.
    pub(in super::super) fn real(&mut self, scalar: Scalar, expected: &str) -> Result<f64, ParseError> {
        match self.encoding {
            Encoding::Text => self.parse(expected),
            Encoding::Binary(order) => Ok(scalar.real(self.one(scalar, expected)?, order)),
        }
    }

    /// An integer, of any size in text.
    pub(in super::super) fn integer(&mut self, scalar: Scalar, expected: &str) -> Result<i64, ParseError> {
        match self.encoding {
            Encoding::Text => self.parse(expected),
            Encoding::Binary(order) => Ok(scalar.integer(self.one(scalar, expected)?, order)),
        }
    }

    /// An integer of eight bytes, not negative. In binary data, an integer above 2⁶³ − 1 becomes 2⁶³ − 1.
    pub(in super::super) fn size(&mut self, expected: &str) -> Result<u64, ParseError> {
        match self.encoding {
            Encoding::Text => self.parse(expected),
            Encoding::Binary(order) => {
                let size = Scalar::U64.integer(self.one(Scalar::U64, expected)?, order);
                Ok(size.unsigned_abs())
            }
        }
    }

    /// So many numbers, the nearest `f64`.
    pub(in super::super) fn reals(&mut self, count: u64, scalar: Scalar) -> Result<Vec<f64>, ParseError> {
        let numbers = match self.encoding {
            Encoding::Text => self.words(count, "a number")?,
            Encoding::Binary(order) => scalar.reals(self.data(count, scalar)?, order),
        };
        self.budget.hold::<f64>(numbers.len());
        Ok(numbers)
    }

    /// So many integers.
    pub(in super::super) fn integers(&mut self, count: u64, scalar: Scalar) -> Result<Vec<i64>, ParseError> {
        let numbers = match self.encoding {
            Encoding::Text => self.words(count, "an integer")?,
            Encoding::Binary(order) => scalar.integers(self.data(count, scalar)?, order),
        };
        self.budget.hold::<i64>(numbers.len());
        Ok(numbers)
    }

    /// Skips so many numbers.
    pub(in super::super) fn skip(&mut self, count: u64, scalar: Scalar) -> Result<(), ParseError> {
        match self.encoding {
            Encoding::Text => (0..count).try_for_each(|_| self.expect_word("a number").map(drop)),
            Encoding::Binary(_) => self.data(count, scalar).map(drop),
        }
    }

    fn words<T: Number>(&mut self, count: u64, expected: &str) -> Result<Vec<T>, ParseError> {
        (0..count).map(|_| self.parse(expected)).collect()
    }

    fn one(&mut self, scalar: Scalar, expected: &str) -> Result<&'a [u8], ParseError> {
        let record = self.record;
        self.bytes(scalar.size() as u64, || format!("{expected} in {record}"))
    }

    fn data(&mut self, count: u64, scalar: Scalar) -> Result<&'a [u8], ParseError> {
        let record = self.record;
        let length = count.saturating_mul(scalar.size() as u64);
        self.bytes(length, || format!("{count} numbers in {record}"))
    }

    /// The next bytes as an array.
    ///
    /// # Errors
    /// As [`Tokens::bytes`].
    pub(in super::super) fn array<const N: usize>(
        &mut self,
        expected: impl Fn() -> String,
    ) -> Result<[u8; N], ParseError> {
        let bytes = self.bytes(N as u64, &expected)?;
        bytes.try_into().map_err(|_| self.ends(expected()))
    }

    /// The next bytes.
    ///
    /// # Errors
    /// At the end of the file, with `expected` as the description of the missing bytes.
    pub(in super::super) fn bytes(
        &mut self,
        length: u64,
        expected: impl FnOnce() -> String,
    ) -> Result<&'a [u8], ParseError> {
        self.line = &[];
        self.token = self.offset();
        let taken = usize::try_from(length)
            .ok()
            .and_then(|length| self.rest.split_off(..length))
            .ok_or_else(|| self.ends(expected()))?;
        self.budget.step(length);
        Ok(taken)
    }
}
