//! Binary data with a current position.

use super::budget::Budget;
use crate::error::{Fault, ParseError, Place};

/// The order of the bytes of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ByteOrder {
    LittleEndian,
    BigEndian,
}

/// The bytes of a file from the current position on.
#[derive(Clone)]
pub(super) struct Bytes<'a> {
    budget: &'a Budget,
    file: &'a [u8],
    offset: usize,
}

impl<'a> Bytes<'a> {
    /// The bytes of `file` from `offset`, which is at most its length.
    pub(super) fn new(file: &'a [u8], offset: usize, budget: &'a Budget) -> Self {
        Self { budget, file, offset }
    }

    pub(super) fn place(&self) -> Place {
        Place::Byte(self.offset)
    }

    /// The current position.
    pub(super) fn offset(&self) -> usize {
        self.offset
    }

    /// The next `length` bytes.
    ///
    /// # Errors
    /// At the end of the file, with `expected` as the description of the missing bytes.
    pub(super) fn take(
        &mut self,
        length: u64,
        expected: impl FnOnce() -> String,
    ) -> Result<&'a [u8], ParseError> {
        let taken = usize::try_from(length)
            .ok()
            .and_then(|length| self.file[self.offset..].get(..length))
            .ok_or_else(|| Fault::ends(expected()).at(self.place()))?;
        self.advance(taken.len());
        Ok(taken)
    }

    /// The next bytes as an array.
    ///
    /// # Errors
    /// As [`Bytes::take`].
    pub(super) fn array<const N: usize>(
        &mut self,
        expected: impl FnOnce() -> String,
    ) -> Result<[u8; N], ParseError> {
        let (&array, _) = self.file[self.offset..]
            .split_first_chunk()
            .ok_or_else(|| Fault::ends(expected()).at(self.place()))?;
        self.advance(N);
        Ok(array)
    }

    /// The bytes of the next number, the least significant first.
    ///
    /// # Errors
    /// As [`Bytes::take`].
    pub(super) fn number<const N: usize>(
        &mut self,
        order: ByteOrder,
        expected: impl FnOnce() -> String,
    ) -> Result<[u8; N], ParseError> {
        let mut number = self.array(expected)?;
        if let ByteOrder::BigEndian = order {
            number.reverse();
        }
        Ok(number)
    }

    /// The text up to the end of the line, without surrounding white space.
    pub(super) fn line(&mut self) -> &'a [u8] {
        let rest = &self.file[self.offset..];
        let length = rest.iter().position(|&byte| byte == b'\n');
        let line = &rest[..length.unwrap_or(rest.len())];
        self.advance(line.len() + usize::from(length.is_some()));
        line.trim_ascii()
    }

    /// The bytes up to the next white space or the end.
    pub(super) fn word(&mut self) -> &'a [u8] {
        let rest = &self.file[self.offset..];
        let length = rest.iter().position(u8::is_ascii_whitespace);
        let word = &rest[..length.unwrap_or(rest.len())];
        self.advance(word.len());
        word
    }

    pub(super) fn is_empty(&self) -> bool {
        self.offset == self.file.len()
    }

    /// Skips white space.
    pub(super) fn skip_blank(&mut self) {
        let rest = &self.file[self.offset..];
        self.advance(rest.len() - rest.trim_ascii_start().len());
    }

    /// Moves to the next occurrence of `text`, if there is one.
    pub(super) fn skip_to(&mut self, text: &[u8]) -> Option<()> {
        let rest = &self.file[self.offset..];
        self.advance(rest.windows(text.len()).position(|window| window == text)?);
        Some(())
    }

    /// Moves over bytes, one step for each.
    fn advance(&mut self, bytes: usize) {
        self.offset += bytes;
        self.budget.step(bytes as u64);
    }

    /// Checks that nothing follows except white space, which some programs write after the data.
    pub(super) fn expect_end(&self) -> Result<(), ParseError> {
        let rest = &self.file[self.offset..];
        if rest.trim_ascii().is_empty() {
            return Ok(());
        }
        Err(Fault::expected("the end of the file", format!("{} more bytes", rest.len())).at(self.place()))
    }
}
