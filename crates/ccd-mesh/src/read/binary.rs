//! A position in binary data.

use super::error::{Fault, ParseError, Place};

/// The bytes of a file from some offset on.
pub(super) struct Bytes<'a> {
    file: &'a [u8],
    offset: usize,
}

impl<'a> Bytes<'a> {
    /// The bytes of `file` from `offset`, which is at most its length.
    pub(super) fn new(file: &'a [u8], offset: usize) -> Self {
        Self { file, offset }
    }

    pub(super) fn place(&self) -> Place {
        Place::Byte(self.offset)
    }

    /// The next `length` bytes.
    ///
    /// # Errors
    /// `expected` names what they are, where the file ends before.
    pub(super) fn take(
        &mut self,
        length: u64,
        expected: impl FnOnce() -> String,
    ) -> Result<&'a [u8], ParseError> {
        let taken = usize::try_from(length)
            .ok()
            .and_then(|length| self.file[self.offset..].get(..length))
            .ok_or_else(|| Fault::ends(expected()).at(self.place()))?;
        self.offset += taken.len();
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
        self.offset += N;
        Ok(array)
    }

    /// Checks that nothing follows but white space, which some programs leave after the data.
    pub(super) fn expect_end(&self) -> Result<(), ParseError> {
        let rest = &self.file[self.offset..];
        if rest.trim_ascii().is_empty() {
            return Ok(());
        }
        Err(Fault::expected("the end of the file", format!("{} more bytes", rest.len())).at(self.place()))
    }
}
