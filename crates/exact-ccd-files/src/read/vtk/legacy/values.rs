//! The words and numbers of a legacy file.

use std::str::FromStr;

use super::super::super::binary::{ByteOrder, Bytes};
use super::super::super::budget::Budget;
use super::super::super::scalar::Scalar;
use super::super::super::text::parse;
use crate::error::{Fault, ParseError, Place, quoted};

/// The file from the current position on.
pub(super) struct Values<'a> {
    budget: &'a Budget,
    file: &'a [u8],
    bytes: Bytes<'a>,
    is_binary: bool,
    /// An offset before the current one, and the number of lines that end before it.
    counted: (usize, usize),
}

impl<'a> Values<'a> {
    /// Reads the first three lines: the version, a title, and the encoding.
    pub(super) fn new(file: &'a [u8], budget: &'a Budget) -> Result<Self, ParseError> {
        let mut bytes = Bytes::new(file, 0, budget);
        let version = bytes.line();
        let major = version
            .strip_prefix(b"# vtk DataFile Version ")
            .and_then(|version| version.trim_ascii_start().first().copied());
        if !matches!(major, Some(b'1'..=b'5')) {
            let expected = "`# vtk DataFile Version` 1 to 5.1";
            return Err(Fault::expected(expected, quoted(version)).at(Place::Line(1)));
        }
        bytes.line();
        let encoding = bytes.line();
        let is_binary = match encoding.to_ascii_uppercase().as_slice() {
            b"ASCII" => false,
            b"BINARY" => true,
            _ => {
                let expected = "`ASCII` or `BINARY`";
                return Err(Fault::expected(expected, quoted(encoding)).at(Place::Line(3)));
            }
        };
        Ok(Self {
            budget,
            file,
            bytes,
            is_binary,
            counted: (0, 0),
        })
    }

    pub(super) fn budget(&self) -> &'a Budget {
        self.budget
    }

    /// The line of a text file, or the byte of a binary one.
    pub(super) fn place(&mut self) -> Place {
        let offset = self.bytes.offset();
        if self.is_binary {
            return Place::Byte(offset);
        }
        let (from, lines) = self.counted;
        let more = self.file[from..offset].iter().filter(|&&byte| byte == b'\n');
        self.counted = (offset, lines + more.count());
        Place::Line(self.counted.1 + 1)
    }

    /// The next word and its place, none at the end of the file.
    pub(super) fn next_word(&mut self) -> Option<(Place, &'a [u8])> {
        self.bytes.skip_blank();
        let place = self.place();
        let word = self.bytes.word();
        (!word.is_empty()).then_some((place, word))
    }

    pub(super) fn word(&mut self, expected: &str) -> Result<(Place, &'a [u8]), ParseError> {
        self.next_word()
            .ok_or_else(|| Fault::ends(expected).at(self.place()))
    }

    /// Reads a word, which must be `keyword`.
    pub(super) fn keyword(&mut self, keyword: &str) -> Result<(), ParseError> {
        let expected = quoted(keyword.as_bytes());
        let (place, word) = self.word(&expected)?;
        match word.eq_ignore_ascii_case(keyword.as_bytes()) {
            true => Ok(()),
            false => Err(Fault::expected(expected, quoted(word)).at(place)),
        }
    }

    /// Reads the next word if it is `keyword`. Returns true if it is.
    pub(super) fn next_is(&mut self, keyword: &[u8]) -> bool {
        let mut ahead = self.bytes.clone();
        ahead.skip_blank();
        let is_it = ahead.word().eq_ignore_ascii_case(keyword);
        if is_it {
            self.bytes = ahead;
        }
        is_it
    }

    pub(super) fn count(&mut self, expected: &str) -> Result<u64, ParseError> {
        let (place, word) = self.word(expected)?;
        parse(word).ok_or_else(|| Fault::expected(expected, quoted(word)).at(place))
    }

    /// Skips the rest of the lines up to an empty one.
    pub(super) fn skip_paragraph(&mut self) {
        self.bytes.line();
        while !self.bytes.line().is_empty() {}
    }

    pub(super) fn reals(&mut self, count: u64, kind: &[u8]) -> Result<Vec<f64>, ParseError> {
        let scalar = self.scalar(kind)?;
        if !self.is_binary {
            return self.texts(count, "a number");
        }
        let data = self.data(count, scalar)?;
        self.budget.hold::<f64>(data.len() / scalar.size());
        Ok(scalar.reals(data, ByteOrder::BigEndian))
    }

    pub(super) fn integers(&mut self, count: u64, kind: &[u8]) -> Result<Vec<i64>, ParseError> {
        let scalar = self.scalar(kind)?;
        if scalar.is_integer() && !self.is_binary {
            return self.texts(count, "an integer");
        }
        let data = self.data(count, scalar)?;
        self.budget.hold::<i64>(data.len() / scalar.size());
        scalar
            .integers(data, ByteOrder::BigEndian)
            .ok_or_else(|| Fault::expected("a type of integers", quoted(kind)).at(self.place()))
    }

    /// Skips numbers or texts.
    pub(super) fn skip(&mut self, count: u64, kind: &[u8]) -> Result<(), ParseError> {
        match (kind, self.is_binary) {
            (b"string", false) => {
                self.bytes.line();
                for _ in 0..count {
                    self.expect_more()?;
                    self.bytes.line();
                }
                Ok(())
            }
            (_, false) => {
                for _ in 0..count {
                    self.word("a number")?;
                }
                Ok(())
            }
            (b"string", true) => {
                self.bytes.line();
                (0..count).try_for_each(|_| self.skip_string())
            }
            (_, true) => {
                let scalar = self.scalar(kind)?;
                self.data(count, scalar).map(drop)
            }
        }
    }

    /// Skips a text of a binary file. Its length comes first, in 1, 2, 4 or 8 bytes, of which the first two
    /// bits are 3, 2, 1 or 0.
    fn skip_string(&mut self) -> Result<(), ParseError> {
        let expected = || "a text and its length".to_owned();
        let first = self.bytes.take(1, expected)?[0];
        let more = [7, 3, 1, 0][usize::from(first >> 6)];
        let rest = self.bytes.take(more, expected)?;
        let length = rest.iter().fold(u64::from(first & 0x3f), |length, &byte| {
            length << 8 | u64::from(byte)
        });
        self.bytes.take(length, expected).map(drop)
    }

    fn expect_more(&mut self) -> Result<(), ParseError> {
        match self.bytes.is_empty() {
            true => Err(Fault::ends("a text").at(self.place())),
            false => Ok(()),
        }
    }

    fn texts<T: FromStr>(&mut self, count: u64, expected: &str) -> Result<Vec<T>, ParseError> {
        let mut numbers = Vec::new();
        for _ in 0..count {
            self.bytes.skip_blank();
            let word = self.bytes.word();
            let number = parse(word).ok_or_else(|| {
                let fault = match word {
                    [] => Fault::ends(expected),
                    _ => Fault::expected(expected, quoted(word)),
                };
                fault.at(self.place())
            });
            numbers.push(number?);
        }
        self.budget.hold::<T>(numbers.len());
        Ok(numbers)
    }

    /// The bytes of numbers, which begin on the next line.
    fn data(&mut self, count: u64, scalar: Scalar) -> Result<&'a [u8], ParseError> {
        self.bytes.line();
        let length = count.saturating_mul(scalar.size() as u64);
        self.bytes.take(length, || format!("{count} numbers"))
    }

    /// The type of numbers with this name.
    fn scalar(&mut self, kind: &[u8]) -> Result<Scalar, ParseError> {
        Ok(match kind.to_ascii_lowercase().as_slice() {
            b"char" | b"signed_char" | b"vtktypeint8" => Scalar::I8,
            b"unsigned_char" | b"vtktypeuint8" => Scalar::U8,
            b"short" | b"vtktypeint16" => Scalar::I16,
            b"unsigned_short" | b"vtktypeuint16" => Scalar::U16,
            // VTK writes ids as 32 bits.
            b"int" | b"vtkidtype" | b"vtktypeint32" => Scalar::I32,
            b"unsigned_int" | b"vtktypeuint32" => Scalar::U32,
            b"long" | b"vtktypeint64" => Scalar::I64,
            b"unsigned_long" | b"vtktypeuint64" => Scalar::U64,
            b"float" => Scalar::F32,
            b"double" => Scalar::F64,
            _ => {
                let expected = "a type of numbers such as `float` or `vtktypeint64`";
                return Err(Fault::expected(expected, quoted(kind)).at(self.place()));
            }
        })
    }
}
