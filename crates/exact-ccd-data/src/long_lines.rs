//! Text without very long lines, so that a reader of lines needs little memory.

use std::io::{self, Read};

/// The most bytes of a line: seven fields, each of the most digits.
const LONGEST: usize = 1 << 16;

/// A text in which a line that is too long is an error.
pub(crate) struct ShortLines<R> {
    text: R,
    /// The number of the current line, from 1, and its bytes so far.
    line: u64,
    length: usize,
}

impl<R> ShortLines<R> {
    pub(crate) fn new(text: R) -> Self {
        Self {
            text,
            line: 1,
            length: 0,
        }
    }
}

impl<R: Read> Read for ShortLines<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.text.read(buffer)?;
        for piece in buffer[..count].split_inclusive(|&byte| byte == b'\n') {
            self.length += piece.len();
            if self.length > LONGEST {
                let message = format!(
                    "line {} has more than {LONGEST} bytes, expected a row of 3 to 7 fields",
                    self.line
                );
                return Err(io::Error::new(io::ErrorKind::InvalidData, message));
            }
            if piece.ends_with(b"\n") {
                self.line += 1;
                self.length = 0;
            }
        }
        Ok(count)
    }
}
