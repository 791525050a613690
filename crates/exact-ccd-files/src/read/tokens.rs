//! The tokens of a file: lines of text and their words, and numbers as text or as binary data.
//!
//! Every reader takes the bytes of a file from here, so that they are counted in one place.

use std::str::FromStr;

use exact_ccd_mesh::Point;

use super::budget::Budget;
use super::record::Record;
use super::scalar::{ByteOrder, Scalar};
use crate::error::{Fault, ParseError, Place, quoted};

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
            rest: file,
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

/// Lines.
impl<'a> Tokens<'a> {
    /// Moves to the next line that is not empty. Returns false at the end of the file.
    pub(super) fn next_line(&mut self) -> bool {
        while !self.rest.is_empty() {
            self.number = self.next_number;
            let (text, start) = (self.rest, self.offset());
            let (mut line, mut continues) = self.cut_line();
            while continues {
                let before = text.len() - self.rest.len();
                (line, continues) = self.cut_line();
                line = &text[..before + line.len()];
            }
            (self.line, self.line_end) = (line, start + line.len());
            self.token = start;
            if !self.is_line_empty() {
                return true;
            }
        }
        self.line = &[];
        self.number = self.next_number;
        self.token = self.file.len();
        false
    }

    /// Moves to the next line.
    ///
    /// # Errors
    /// At the end of the file, with `expected` as the description of the missing line.
    pub(super) fn expect_line(&mut self, expected: impl FnOnce() -> String) -> Result<(), ParseError> {
        match self.next_line() {
            true => Ok(()),
            false => Err(self.ends(expected())),
        }
    }

    /// Removes one line and returns it without its comment and line break, and true if the next line continues
    /// it.
    fn cut_line(&mut self) -> (&'a [u8], bool) {
        let length = self.rest.iter().position(|&byte| byte == b'\n');
        let (line, rest) = self.rest.split_at(length.unwrap_or(self.rest.len()));
        self.rest = rest.get(1..).unwrap_or(&[]);
        self.budget.step(line.len() as u64 + 1);
        self.next_number += usize::from(length.is_some());
        let comment = match self.syntax {
            Syntax::Lines | Syntax::Free => None,
            Syntax::Comments | Syntax::CommentsAndContinuation => line.iter().position(|&byte| byte == b'#'),
        };
        let line = comment.map_or(line, |comment| &line[..comment]);
        let continues = self.syntax == Syntax::CommentsAndContinuation
            && length.is_some()
            && line.trim_ascii_end().ends_with(b"\\");
        (line, continues)
    }

    /// The rest of the current line, which is read with this.
    pub(super) fn rest_of_line(&mut self) -> &'a [u8] {
        std::mem::take(&mut self.line).trim_ascii()
    }

    /// The text of the next line, which may be empty, in place of the current one.
    pub(super) fn whole_line(&mut self) -> &'a [u8] {
        self.number = self.next_number;
        self.token = self.offset();
        self.line = &[];
        self.cut_line().0.trim_ascii()
    }

    /// Skips everything up to this text, which begins a line, and that line.
    pub(super) fn skip_to(&mut self, end: &str) -> Result<(), ParseError> {
        let mut windows = self.rest.windows(end.len());
        let length = windows.position(|window| window == end.as_bytes());
        let (skipped, rest) = self.rest.split_at(length.unwrap_or(self.rest.len()));
        self.budget.step(skipped.len() as u64);
        self.next_number += skipped.iter().filter(|&&byte| byte == b'\n').count();
        self.rest = rest;
        self.expect_line_of(end)
    }

    /// Checks that the next line consists of this word.
    pub(super) fn expect_line_of(&mut self, word: &str) -> Result<(), ParseError> {
        self.expect_line(|| quoted(word.as_bytes()))?;
        self.keyword(word)?;
        self.expect_line_end()
    }

    pub(super) fn expect_line_end(&self) -> Result<(), ParseError> {
        if self.is_line_empty() {
            return Ok(());
        }
        Err(self.unexpected("the end of the line", self.line.trim_ascii()))
    }

    pub(super) fn is_line_empty(&self) -> bool {
        self.line.iter().all(|&byte| self.is_blank(byte))
    }

    fn is_blank(&self, byte: u8) -> bool {
        byte.is_ascii_whitespace() || (byte == b'\\' && self.syntax == Syntax::CommentsAndContinuation)
    }

    /// Checks that nothing follows, except white space after binary data, which some programs write.
    pub(super) fn expect_end(&mut self) -> Result<(), ParseError> {
        let (start, left) = (self.offset(), self.rest.len());
        if !self.next_line() {
            return Ok(());
        }
        if !self.is_binary() {
            return Err(self.unexpected("the end of the file", self.line.trim_ascii()));
        }
        self.token = start;
        Err(Fault::expected("the end of the file", format!("{left} more bytes")).at(self.place()))
    }
}

/// Words.
impl<'a> Tokens<'a> {
    /// The next word, if there is one.
    pub(super) fn word(&mut self) -> Option<&'a [u8]> {
        loop {
            if let Some(start) = self.line.iter().position(|&byte| !self.is_blank(byte)) {
                let text = &self.line[start..];
                let length = text.iter().position(|&byte| self.is_blank(byte));
                let (word, rest) = text.split_at(length.unwrap_or(text.len()));
                self.line = rest;
                self.token = self.line_end - text.len();
                return Some(word);
            }
            if self.syntax != Syntax::Free || !self.next_line() {
                return None;
            }
        }
    }

    /// The next word.
    ///
    /// # Errors
    /// At the end of the line or, where words are on any lines, of the file.
    pub(super) fn expect_word(&mut self, expected: &str) -> Result<&'a [u8], ParseError> {
        self.word().ok_or_else(|| match self.syntax {
            Syntax::Free => self.ends(expected),
            _ => Fault::expected(expected, "the end of the line").at(self.place()),
        })
    }

    /// Reads the next word, which must be `keyword`, in upper or lower case.
    pub(super) fn keyword(&mut self, keyword: &str) -> Result<(), ParseError> {
        match self.word() {
            Some(word) if is(word, keyword) => Ok(()),
            Some(word) => Err(self.unexpected(quoted(keyword.as_bytes()), word)),
            None => self.expect_word(&quoted(keyword.as_bytes())).map(drop),
        }
    }

    /// Reads the next word if it is `keyword`. Returns true if it is.
    pub(super) fn next_is(&mut self, keyword: &str) -> bool {
        let mut ahead = self.clone();
        let is_it = ahead.word().is_some_and(|word| is(word, keyword));
        if is_it {
            *self = ahead;
        }
        is_it
    }

    /// The next word as a number: the nearest `f64`, or an integer. It is text in a binary file, too.
    pub(super) fn parse<T: FromStr>(&mut self, expected: &str) -> Result<T, ParseError> {
        let word = self.expect_word(expected)?;
        parse(word).ok_or_else(|| self.unexpected(expected, word))
    }

    /// The next word as a count. It is text in a binary file, too.
    pub(super) fn count(&mut self, expected: &str) -> Result<u64, ParseError> {
        self.parse(expected)
    }

    /// The next three words as coordinates.
    pub(super) fn point(&mut self) -> Result<Point, ParseError> {
        const NUMBER: &str = "a number";
        Ok([self.parse(NUMBER)?, self.parse(NUMBER)?, self.parse(NUMBER)?])
    }

    /// All words that are left as numbers.
    pub(super) fn numbers<T: FromStr>(&mut self, expected: &str) -> Result<Vec<T>, ParseError> {
        let mut numbers = Vec::new();
        while let Some(word) = self.word() {
            numbers.push(parse(word).ok_or_else(|| self.unexpected(expected, word))?);
        }
        self.budget.hold::<T>(numbers.len());
        Ok(numbers)
    }
}

/// Numbers in the encoding of the file. `expected` describes a number in errors.
impl<'a> Tokens<'a> {
    /// Moves to the beginning of a record: in text, to its line.
    pub(super) fn begin(&mut self, record: Record<'a>) -> Result<(), ParseError> {
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
    pub(super) fn end(&self) -> Result<(), ParseError> {
        match self.encoding {
            Encoding::Text => self.expect_line_end(),
            Encoding::Binary(_) => Ok(()),
        }
    }

    /// The nearest `f64`, whatever the type in text.
    pub(super) fn real(&mut self, scalar: Scalar, expected: &str) -> Result<f64, ParseError> {
        match self.encoding {
            Encoding::Text => self.parse(expected),
            Encoding::Binary(order) => Ok(scalar.real(self.one(scalar, expected)?, order)),
        }
    }

    /// An integer, of any size in text.
    pub(super) fn integer(&mut self, scalar: Scalar, expected: &str) -> Result<i64, ParseError> {
        match self.encoding {
            Encoding::Text => self.parse(expected),
            Encoding::Binary(order) => Ok(scalar.integer(self.one(scalar, expected)?, order)),
        }
    }

    /// An integer of eight bytes, not negative; one above 2⁶³ − 1 in binary data as that.
    pub(super) fn size(&mut self, expected: &str) -> Result<u64, ParseError> {
        match self.encoding {
            Encoding::Text => self.parse(expected),
            Encoding::Binary(order) => {
                let size = Scalar::U64.integer(self.one(Scalar::U64, expected)?, order);
                Ok(size.unsigned_abs())
            }
        }
    }

    /// So many numbers, the nearest `f64`.
    pub(super) fn reals(&mut self, count: u64, scalar: Scalar) -> Result<Vec<f64>, ParseError> {
        let numbers = match self.encoding {
            Encoding::Text => self.words(count, "a number")?,
            Encoding::Binary(order) => scalar.reals(self.data(count, scalar)?, order),
        };
        self.budget.hold::<f64>(numbers.len());
        Ok(numbers)
    }

    /// So many integers.
    pub(super) fn integers(&mut self, count: u64, scalar: Scalar) -> Result<Vec<i64>, ParseError> {
        let numbers = match self.encoding {
            Encoding::Text => self.words(count, "an integer")?,
            Encoding::Binary(order) => scalar.integers(self.data(count, scalar)?, order),
        };
        self.budget.hold::<i64>(numbers.len());
        Ok(numbers)
    }

    /// Skips so many numbers.
    pub(super) fn skip(&mut self, count: u64, scalar: Scalar) -> Result<(), ParseError> {
        match self.encoding {
            Encoding::Text => (0..count).try_for_each(|_| self.expect_word("a number").map(drop)),
            Encoding::Binary(_) => self.data(count, scalar).map(drop),
        }
    }

    fn words<T: FromStr>(&mut self, count: u64, expected: &str) -> Result<Vec<T>, ParseError> {
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
    pub(super) fn array<const N: usize>(
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
    pub(super) fn bytes(
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

/// Returns true if a word is this keyword, in upper or lower case.
pub(super) fn is(word: &[u8], keyword: &str) -> bool {
    word.eq_ignore_ascii_case(keyword.as_bytes())
}

/// A word as a number.
pub(super) fn parse<T: FromStr>(word: &[u8]) -> Option<T> {
    std::str::from_utf8(word).ok()?.parse().ok()
}
