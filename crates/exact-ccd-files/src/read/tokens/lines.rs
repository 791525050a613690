//! The lines of a file.

use std::io::BufRead;

use super::{Syntax, Tokens};
use crate::error::{Fault, ParseError, quoted};

impl<'a> Tokens<'a> {
    /// Moves to the next line that is not empty. Returns false at the end of the file.
    pub(in super::super) fn next_line(&mut self) -> bool {
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
    pub(in super::super) fn expect_line(
        &mut self,
        expected: impl FnOnce() -> String,
    ) -> Result<(), ParseError> {
        match self.next_line() {
            true => Ok(()),
            false => Err(self.ends(expected())),
        }
    }

    /// Removes one line and returns it without its comment and line break, and true if the next line
    /// continues it.
    fn cut_line(&mut self) -> (&'a [u8], bool) {
        let length = find(self.rest, b'\n');
        let (line, rest) = self.rest.split_at(length.unwrap_or(self.rest.len()));
        self.rest = rest.get(1..).unwrap_or(&[]);
        self.budget.step(line.len() as u64 + 1);
        self.next_number += usize::from(length.is_some());
        let comment = match self.syntax {
            Syntax::Lines | Syntax::Free => None,
            Syntax::Comments | Syntax::CommentsAndContinuation => find(line, b'#'),
        };
        let line = comment.map_or(line, |comment| &line[..comment]);
        let continues = self.syntax == Syntax::CommentsAndContinuation
            && length.is_some()
            && line.trim_ascii_end().ends_with(b"\\");
        (line, continues)
    }

    /// The rest of the current line with its blanks, which is read with this.
    pub(in super::super) fn rest_of_line(&mut self) -> &'a [u8] {
        std::mem::take(&mut self.line)
    }

    /// The text of the next line, which may be empty, in place of the current one.
    pub(in super::super) fn whole_line(&mut self) -> &'a [u8] {
        self.number = self.next_number;
        self.token = self.offset();
        self.line = &[];
        self.cut_line().0.trim_ascii()
    }

    /// Skips everything up to this text, which begins a line, and that line.
    pub(in super::super) fn skip_to(&mut self, end: &str) -> Result<(), ParseError> {
        let mut windows = self.rest.windows(end.len());
        let length = windows.position(|window| window == end.as_bytes());
        let (skipped, rest) = self.rest.split_at(length.unwrap_or(self.rest.len()));
        self.budget.step(skipped.len() as u64);
        self.next_number += skipped.iter().filter(|&&byte| byte == b'\n').count();
        self.rest = rest;
        self.expect_line_of(end)
    }

    /// Checks that the next line consists of this word.
    pub(in super::super) fn expect_line_of(&mut self, word: &str) -> Result<(), ParseError> {
        self.expect_line(|| quoted(word.as_bytes()))?;
        self.keyword(word)?;
        self.expect_line_end()
    }

    pub(in super::super) fn expect_line_end(&self) -> Result<(), ParseError> {
        if self.is_line_empty() {
            return Ok(());
        }
        Err(self.unexpected("the end of the line", self.line.trim_ascii()))
    }

    pub(in super::super) fn is_line_empty(&self) -> bool {
        self.line.iter().all(self.syntax.blank())
    }

    /// Checks that nothing follows, except white space after binary data, which some programs write.
    pub(in super::super) fn expect_end(&mut self) -> Result<(), ParseError> {
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

/// The offset of the first byte of this value. The standard library searches for it with vectors.
fn find(bytes: &[u8], byte: u8) -> Option<usize> {
    let mut rest = bytes;
    let skipped = rest.skip_until(byte).ok()?;
    bytes[..skipped].strip_suffix(&[byte]).map(<[u8]>::len)
}
