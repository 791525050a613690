//! The header of an array: a dictionary of Python.
//!
//! numpy documentation, *A simple file format for NumPy arrays* (`numpy.lib.format`).

use std::fmt;

use super::super::budget::Budget;
use super::super::scalar::{ByteOrder, Scalar};
use super::super::tokens::Tokens;
use crate::error::{Fault, ParseError, quoted};

/// The most dimensions of an array, as in numpy before version 2.
const MOST_DIMENSIONS: usize = 32;

/// The type and the shape of an array.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Header {
    pub(super) scalar: Scalar,
    pub(super) order: ByteOrder,
    /// The first index varies fastest.
    pub(super) is_fortran: bool,
    pub(super) shape: Vec<usize>,
    /// The number of bytes before the data.
    pub(super) length: usize,
    /// The type as numpy writes it, such as `<f4`.
    pub(super) descr: String,
}

/// A value of the dictionary.
enum Value<'a> {
    Text(&'a str),
    Truth(bool),
    Shape(Vec<usize>),
}

impl Header {
    pub(super) fn read(file: &[u8], budget: &Budget) -> Result<Self, ParseError> {
        let mut tokens = Tokens::binary(file, 0, budget);
        let magic: [u8; 8] = tokens.array(|| "`\\x93NUMPY` and a version".to_owned())?;
        if !magic.starts_with(b"\x93NUMPY") {
            return Err(Fault::expected("`\\x93NUMPY`", quoted(&magic[..6])).at(tokens.place()));
        }
        let size = || "the length of the header".to_owned();
        let length = match magic[6] {
            1 => u16::from_le_bytes(tokens.array(size)?).into(),
            2 | 3 => u32::from_le_bytes(tokens.array(size)?),
            other => return Err(Fault::expected("version 1 to 3", other.to_string()).at(tokens.place())),
        };
        let text = tokens.bytes(length.into(), || format!("a header of {length} bytes"))?;
        let place = tokens.place();
        let header = std::str::from_utf8(text).ok().and_then(dictionary);
        let Some((descr, is_fortran, shape)) = header else {
            let expected = "a dictionary of descr, fortran_order and shape of numbers";
            return Err(Fault::expected(expected, quoted(text)).at(place));
        };
        if shape.len() > MOST_DIMENSIONS {
            let expected = format!("an array of at most {MOST_DIMENSIONS} dimensions");
            return Err(Fault::expected(expected, shape.len().to_string()).at(place));
        }
        let (scalar, order) = number(descr).ok_or_else(|| {
            let expected = "an array of floats of 2 to 8 bytes or of integers";
            Fault::expected(expected, quoted(descr.as_bytes())).at(place)
        })?;
        Ok(Self {
            scalar,
            order,
            is_fortran,
            shape,
            length: tokens.offset(),
            descr: descr.to_owned(),
        })
    }

    /// The number of bytes of the data, none if it exceeds all bounds.
    pub(super) fn data_length(&self) -> Option<usize> {
        let product = |length: usize, &count: &usize| length.checked_mul(count);
        self.shape.iter().try_fold(self.scalar.size(), product)
    }
}

/// The type and the shape, as `<f4 (2, 10, 3)`.
impl fmt::Display for Header {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let shape: Vec<String> = self.shape.iter().map(usize::to_string).collect();
        write!(f, "{} ({})", self.descr, shape.join(", "))
    }
}

/// The type of the numbers, from a text such as `<f4`.
fn number(descr: &str) -> Option<(Scalar, ByteOrder)> {
    let (order, kind) = match descr.split_at_checked(1)? {
        ("<" | "|", kind) => (ByteOrder::LittleEndian, kind),
        (">", kind) => (ByteOrder::BigEndian, kind),
        _ => return None,
    };
    Some((Scalar::named(kind.as_bytes())?, order))
}

/// The type, the order and the shape in `{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3)}`.
fn dictionary(text: &str) -> Option<(&str, bool, Vec<usize>)> {
    let mut rest = text.trim().strip_prefix('{')?.strip_suffix('}')?.trim();
    let (mut descr, mut is_fortran, mut shape) = (None, None, None);
    while !rest.is_empty() {
        let (key, after) = quoted_text(rest)?;
        let (value, after) = value(after.trim_start().strip_prefix(':')?.trim_start())?;
        match (key, value) {
            ("descr", Value::Text(text)) => descr = Some(text),
            ("fortran_order", Value::Truth(truth)) => is_fortran = Some(truth),
            ("shape", Value::Shape(counts)) => shape = Some(counts),
            _ => return None,
        }
        let after = after.trim_start();
        rest = after.strip_prefix(',').unwrap_or(after).trim_start();
    }
    Some((descr?, is_fortran?, shape?))
}

/// The value at the beginning of a text, and the text after it.
fn value(text: &str) -> Option<(Value<'_>, &str)> {
    if let Some(rest) = text.strip_prefix("True") {
        return Some((Value::Truth(true), rest));
    }
    if let Some(rest) = text.strip_prefix("False") {
        return Some((Value::Truth(false), rest));
    }
    if let Some(rest) = text.strip_prefix('(') {
        let (inside, rest) = rest.split_once(')')?;
        let counts = inside.split(',').map(str::trim);
        let counts = counts.filter(|count| !count.is_empty());
        let counts = counts.map(|count| count.trim_end_matches('L').parse().ok());
        return Some((Value::Shape(counts.collect::<Option<_>>()?), rest));
    }
    let (text, rest) = quoted_text(text)?;
    Some((Value::Text(text), rest))
}

/// The text in quotes at the beginning, and the text after it.
fn quoted_text(text: &str) -> Option<(&str, &str)> {
    let quote = text.chars().next().filter(|quote| matches!(quote, '\'' | '"'))?;
    text[1..].split_once(quote)
}
