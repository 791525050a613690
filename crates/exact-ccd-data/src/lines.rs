//! The lines of a text file, and the fields of CSV. All bytes are counted here.

use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

use exact_ccd_files::Budget;

use crate::error::{DataError, Problem};

/// The most bytes of a line: seven fields, each of the most digits.
const LONGEST: usize = 1 << 16;

/// The lines of a text, one at a time.
pub(crate) struct Lines<R> {
    file: PathBuf,
    text: BufReader<R>,
    line: Vec<u8>,
    /// The number of the line, from 1.
    number: u64,
    budget: Budget,
}

impl<R: Read> Lines<R> {
    pub(crate) fn new(file: PathBuf, text: R) -> Self {
        Self {
            file,
            text: BufReader::new(text),
            line: Vec::new(),
            number: 0,
            budget: Budget::new(u64::MAX),
        }
    }

    /// Moves to the next line that is not blank. Returns false at the end of the file.
    pub(crate) fn next(&mut self) -> Result<bool, DataError> {
        loop {
            self.line.clear();
            let mut longest = (&mut self.text).take(LONGEST as u64 + 1);
            let read = longest.read_until(b'\n', &mut self.line);
            let length = read.map_err(|source| DataError::io(&self.file, source))?;
            self.budget.step(length as u64);
            if length == 0 {
                return Ok(false);
            }
            self.number += 1;
            if length > LONGEST {
                return Err(self.error(Problem::LongLine { longest: LONGEST }));
            }
            if self.number == 1 && self.line.starts_with(b"\xef\xbb\xbf") {
                self.line.drain(..3);
            }
            if !self.line.trim_ascii().is_empty() {
                return Ok(true);
            }
        }
    }

    /// The line, with its end.
    pub(crate) fn text(&self) -> &[u8] {
        &self.line
    }

    /// The fields of the line, without blanks around them. There are no quotes.
    pub(crate) fn fields(&self) -> impl Iterator<Item = &[u8]> {
        self.line.split(|&byte| byte == b',').map(<[u8]>::trim_ascii)
    }

    pub(crate) fn number(&self) -> u64 {
        self.number
    }

    pub(crate) fn file(&self) -> &Path {
        &self.file
    }

    /// An error in the line.
    pub(crate) fn error(&self, problem: Problem) -> DataError {
        DataError::line(&self.file, self.number, problem)
    }

    /// The account of the reading so far.
    #[cfg(test)]
    pub(crate) fn budget(&self) -> &Budget {
        &self.budget
    }
}
