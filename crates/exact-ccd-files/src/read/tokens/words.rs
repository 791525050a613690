//! The words of a file, and numbers that are words in every encoding.

use exact_ccd_mesh::Point;

use super::{Number, Syntax, Tokens};
use crate::error::{Fault, ParseError, quoted};

impl<'a> Tokens<'a> {
    /// The next word, if there is one.
    #[inline]
    pub(in super::super) fn word(&mut self) -> Option<&'a [u8]> {
        let is_blank = self.syntax.blank();
        loop {
            if let Some(start) = self.line.iter().position(|byte| !is_blank(byte)) {
                let text = &self.line[start..];
                let length = text.iter().position(&is_blank);
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
    #[inline]
    pub(in super::super) fn expect_word(&mut self, expected: &str) -> Result<&'a [u8], ParseError> {
        self.word().ok_or_else(|| self.no_word(expected))
    }

    #[cold]
    fn no_word(&self, expected: &str) -> ParseError {
        match self.syntax {
            Syntax::Free => self.ends(expected),
            _ => Fault::expected(expected, "the end of the line").at(self.place()),
        }
    }

    /// Reads the next word, which must be `keyword`, in upper or lower case.
    pub(in super::super) fn keyword(&mut self, keyword: &str) -> Result<(), ParseError> {
        match self.word() {
            Some(word) if is(word, keyword) => Ok(()),
            Some(word) => Err(self.unexpected(quoted(keyword.as_bytes()), word)),
            None => Err(self.no_word(&quoted(keyword.as_bytes()))),
        }
    }

    /// Reads the next word if it is `keyword`. Returns true if it is.
    pub(in super::super) fn next_is(&mut self, keyword: &str) -> bool {
        let mut ahead = self.clone();
        let is_it = ahead.word().is_some_and(|word| is(word, keyword));
        if is_it {
            *self = ahead;
        }
        is_it
    }

    /// The next word as a number: the nearest `f64`, or an integer. It is text in a binary file, too.
    #[inline]
    pub(in super::super) fn parse<T: Number>(&mut self, expected: &str) -> Result<T, ParseError> {
        let word = self.expect_word(expected)?;
        T::parse(word).ok_or_else(|| self.unexpected(expected, word))
    }

    /// The next word as a count. It is text in a binary file, too.
    pub(in super::super) fn count(&mut self, expected: &str) -> Result<u64, ParseError> {
        self.parse(expected)
    }

    /// The next three words as coordinates, which are finite.
    pub(in super::super) fn point(&mut self) -> Result<Point, ParseError> {
        Ok([self.coordinate()?, self.coordinate()?, self.coordinate()?])
    }

    /// The next word as a coordinate, which is finite.
    #[inline]
    pub(in super::super) fn coordinate(&mut self) -> Result<f64, ParseError> {
        const NUMBER: &str = "a number";
        let word = self.expect_word(NUMBER)?;
        let number = f64::parse(word).ok_or_else(|| self.unexpected(NUMBER, word))?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(self.unexpected("a finite number", word))
        }
    }

    /// All words that are left as numbers.
    pub(in super::super) fn numbers<T: Number>(&mut self, expected: &str) -> Result<Vec<T>, ParseError> {
        let mut numbers = Vec::new();
        while let Some(word) = self.word() {
            numbers.push(T::parse(word).ok_or_else(|| self.unexpected(expected, word))?);
        }
        self.budget.hold::<T>(numbers.len());
        Ok(numbers)
    }
}

/// Returns true if a word is this keyword, in upper or lower case.
pub(in super::super) fn is(word: &[u8], keyword: &str) -> bool {
    word.eq_ignore_ascii_case(keyword.as_bytes())
}
