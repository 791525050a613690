//! The tokens of a file: lines of text and their words, and numbers as text or as binary data.
//!
//! Every reader takes the bytes of a file from here, so that they are counted in one place.

mod encoded;
mod lines;
mod number;
mod words;

use super::budget::Budget;
use super::record::Record;
use super::scalar::ByteOrder;
use crate::error::{Fault, ParseError, Place, quoted};
pub(super) use number::Number;
pub(super) use words::is;

/// The syntax of text besides words.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Syntax {
    /// A word is on the current line.
    Lines,
    /// The same, with comments from `#` to the end of the line.
    Comments,
    /// The same, with `\` at the end of a line that the next line continues.
    CommentsAndContinuation,
    /// A word is on the current line or on a later one.
    Free,
}

impl Syntax {
    /// The test for a byte between words.
    fn blank(self) -> impl Fn(&u8) -> bool {
        let other = match self {
            Self::CommentsAndContinuation => b'\\',
            _ => b' ',
        };
        move |&byte| byte == other || byte.is_ascii_whitespace()
    }
}

/// The encoding of numbers.
#[derive(Clone, Copy)]
pub(super) enum Encoding {
    Text,
    Binary(ByteOrder),
}

/// A file from the current position on.
///
/// Words come from the current line. Binary data begin after it, where the next line would.
#[derive(Clone)]
pub(super) struct Tokens<'a> {
    budget: &'a Budget,
    file: &'a [u8],
    syntax: Syntax,
    encoding: Encoding,
    record: Record<'a>,
    /// The rest of the current line, without its comment and its line break, and the offset of its end.
    line: &'a [u8],
    line_end: usize,
    /// The number of the current line, from 1.
    number: usize,
    /// The file after the current line, and the number of its first line.
    rest: &'a [u8],
    next_number: usize,
    /// The offset of the last token, or of the place of a missing one.
    token: usize,
}

impl<'a> Tokens<'a> {
    /// The tokens of a file that begins with text.
    pub(super) fn text(file: &'a [u8], syntax: Syntax, budget: &'a Budget) -> Self {
        Self {
            budget,
            file,
            syntax,
            encoding: Encoding::Text,
            record: Record::one("the file"),
            line: &[],
            line_end: 0,
            number: 1,
            // Without a byte order mark.
            rest: file.strip_prefix(b"\xef\xbb\xbf").unwrap_or(file),
            next_number: 1,
            token: 0,
        }
    }

    /// The numbers of a binary file, the least significant byte first, from `offset` on, which is at most its
    /// length.
    pub(super) fn binary(file: &'a [u8], offset: usize, budget: &'a Budget) -> Self {
        Self {
            encoding: Encoding::Binary(ByteOrder::LittleEndian),
            rest: &file[offset..],
            token: offset,
            ..Self::text(file, Syntax::Lines, budget)
        }
    }

    /// Numbers have this encoding from here on. Errors name the byte of a binary file.
    pub(super) fn set_encoding(&mut self, encoding: Encoding) {
        self.encoding = encoding;
        self.token = self.offset();
    }

    pub(super) fn is_binary(&self) -> bool {
        matches!(self.encoding, Encoding::Binary(_))
    }

    pub(super) fn budget(&self) -> &'a Budget {
        self.budget
    }

    /// The place of the last token: its line, or its byte in a binary file.
    pub(super) fn place(&self) -> Place {
        match self.encoding {
            Encoding::Text => Place::Line(self.number),
            Encoding::Binary(_) => Place::Byte(self.token),
        }
    }

    /// The file after the current line.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest
    }

    /// The offset of binary data, or of the next line.
    pub(super) fn offset(&self) -> usize {
        self.file.len() - self.rest.len()
    }

    /// Returns true if no byte is left after the current line.
    pub(super) fn is_at_end(&self) -> bool {
        self.rest.is_empty()
    }

    /// The error that `found` is in the place of `expected`.
    pub(super) fn unexpected(&self, expected: impl Into<String>, found: &[u8]) -> ParseError {
        Fault::expected(expected, quoted(found)).at(self.place())
    }

    /// The error that the file ends.
    pub(super) fn ends(&self, expected: impl Into<String>) -> ParseError {
        Fault::ends(expected).at(self.place())
    }
}
