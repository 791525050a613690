//! Lines of text and their words.

use super::budget::Budget;
use crate::error::{Fault, ParseError, Place, quoted};

/// The syntax of lines besides words.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Syntax {
    /// Words only.
    #[default]
    Plain,
    /// Comments, from `#` to the end of the line.
    Comments,
    /// Comments, and `\` at the end of a line that the next line continues.
    CommentsAndContinuation,
}

/// The lines of a text without the empty ones.
pub(super) struct Lines<'a> {
    budget: &'a Budget,
    rest: &'a [u8],
    next_number: usize,
    syntax: Syntax,
}

/// The words of a line that have not been read.
#[derive(Clone, Default)]
pub(super) struct Line<'a> {
    number: usize,
    rest: &'a [u8],
    syntax: Syntax,
}

impl<'a> Lines<'a> {
    pub(super) fn new(bytes: &'a [u8], syntax: Syntax, budget: &'a Budget) -> Self {
        Self {
            budget,
            rest: bytes,
            next_number: 1,
            syntax,
        }
    }

    /// The text after the last line that was read.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest
    }

    /// The next line.
    ///
    /// # Errors
    /// At the end of the file, with `expected` as the description of the missing line.
    pub(super) fn expect(&mut self, expected: impl FnOnce() -> String) -> Result<Line<'a>, ParseError> {
        self.next().ok_or_else(|| Fault::ends(expected()).at(self.end()))
    }

    pub(super) fn expect_end(&mut self) -> Result<(), ParseError> {
        self.next().map_or(Ok(()), |line| {
            Err(line.unexpected("the end of the file", line.rest.trim_ascii()))
        })
    }

    /// The place of the end of the text, once all lines are read.
    pub(super) fn end(&self) -> Place {
        Place::Line(self.next_number)
    }

    /// Removes one line and returns it without its comment and line break, and true if the next
    /// line continues it.
    fn cut_line(&mut self) -> (&'a [u8], bool) {
        let length = self.rest.iter().position(|&byte| byte == b'\n');
        let (line, rest) = self.rest.split_at(length.unwrap_or(self.rest.len()));
        self.rest = rest.get(1..).unwrap_or(&[]);
        self.budget.step(line.len() as u64 + 1);
        self.next_number += usize::from(length.is_some());
        let comment = match self.syntax {
            Syntax::Plain => None,
            Syntax::Comments | Syntax::CommentsAndContinuation => line.iter().position(|&byte| byte == b'#'),
        };
        let line = comment.map_or(line, |comment| &line[..comment]);
        let continues = self.syntax == Syntax::CommentsAndContinuation
            && length.is_some()
            && line.trim_ascii_end().ends_with(b"\\");
        (line, continues)
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        while !self.rest.is_empty() {
            let number = self.next_number;
            let text = self.rest;
            let (mut line, mut continues) = self.cut_line();
            while continues {
                let before = text.len() - self.rest.len();
                (line, continues) = self.cut_line();
                line = &text[..before + line.len()];
            }
            let line = Line {
                number,
                rest: line,
                syntax: self.syntax,
            };
            if !line.is_empty() {
                return Some(line);
            }
        }
        None
    }
}

impl<'a> Line<'a> {
    /// The rest of the line.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest
    }

    /// The number of the line, from 1.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    pub(super) fn place(&self) -> Place {
        Place::Line(self.number)
    }

    /// The next word, if there is one.
    pub(super) fn word(&mut self) -> Option<&'a [u8]> {
        let start = self.rest.iter().position(|&byte| !self.is_blank(byte))?;
        let word = &self.rest[start..];
        let end = word.iter().position(|&byte| self.is_blank(byte));
        let (word, rest) = word.split_at(end.unwrap_or(word.len()));
        self.rest = rest;
        Some(word)
    }

    /// The next word, or an error at the end of the line.
    pub(super) fn expect_word(&mut self, expected: &str) -> Result<&'a [u8], ParseError> {
        self.word().ok_or_else(|| self.ends(expected))
    }

    /// The next word as a number: the nearest `f64`.
    pub(super) fn coordinate(&mut self) -> Result<f64, ParseError> {
        self.parse("a number")
    }

    /// The next word as a number, the nearest `f64`. `expected` describes it in errors.
    pub(super) fn real(&mut self, expected: &str) -> Result<f64, ParseError> {
        self.parse(expected)
    }

    /// The next word as a whole number.
    pub(super) fn integer(&mut self, expected: &str) -> Result<i64, ParseError> {
        self.parse(expected)
    }

    /// The next word as a count.
    pub(super) fn count(&mut self, expected: &str) -> Result<u64, ParseError> {
        self.parse(expected)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.rest.iter().all(|&byte| self.is_blank(byte))
    }

    pub(super) fn expect_end(&self) -> Result<(), ParseError> {
        if self.is_empty() {
            return Ok(());
        }
        Err(self.unexpected("the end of the line", self.rest.trim_ascii()))
    }

    /// The error that `found` is in the place of `expected`.
    pub(super) fn unexpected(&self, expected: impl Into<String>, found: &[u8]) -> ParseError {
        Fault::expected(expected, quoted(found)).at(self.place())
    }

    fn ends(&self, expected: &str) -> ParseError {
        Fault::expected(expected, "the end of the line").at(self.place())
    }

    fn parse<T: std::str::FromStr>(&mut self, expected: &str) -> Result<T, ParseError> {
        let word = self.expect_word(expected)?;
        parse(word).ok_or_else(|| self.unexpected(expected, word))
    }

    fn is_blank(&self, byte: u8) -> bool {
        byte.is_ascii_whitespace() || (byte == b'\\' && self.syntax == Syntax::CommentsAndContinuation)
    }
}

/// Reads the next word of a line, which must be `expected`.
pub(super) fn expect(line: &mut Line, expected: &str) -> Result<(), ParseError> {
    let expected_quoted = quoted(expected.as_bytes());
    let word = line.expect_word(&expected_quoted)?;
    if word == expected.as_bytes() {
        return Ok(());
    }
    Err(line.unexpected(expected_quoted, word))
}

/// A word as a number.
pub(super) fn parse<T: std::str::FromStr>(word: &[u8]) -> Option<T> {
    std::str::from_utf8(word).ok()?.parse().ok()
}
