//! Arrays of numbers, inline: as text, or in base64.

use std::str::FromStr;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use roxmltree::Node;

use super::super::binary::ByteOrder;
use super::super::text::parse;
use super::xml::File;
use crate::error::{ParseError, quoted};

/// The encoding of numbers in a file.
pub(super) struct Encoding {
    order: ByteOrder,
    /// The size of the length of an array, in bytes.
    header: usize,
}

impl Encoding {
    pub(super) fn of<'a>(file: &File<'a>) -> Result<Self, ParseError> {
        let root = file.root;
        let unexpected =
            |expected: &str, found: &str| Err(file.fault(root, expected, quoted(found.as_bytes())));
        if let Some(compressor) = root.attribute("compressor") {
            return unexpected("data that are not compressed", compressor);
        }
        let order = match file.attribute(root, "byte_order")? {
            "LittleEndian" => ByteOrder::LittleEndian,
            "BigEndian" => ByteOrder::BigEndian,
            other => return unexpected("`LittleEndian` or `BigEndian`", other),
        };
        let header = match root.attribute("header_type") {
            None | Some("UInt32") => 4,
            Some("UInt64") => 8,
            Some(other) => return unexpected("`UInt32` or `UInt64`", other),
        };
        Ok(Self { order, header })
    }

    pub(super) fn reals<'a>(&self, file: &File<'a>, array: Node<'a, 'a>) -> Result<Vec<f64>, ParseError> {
        match file.attribute(array, "type")? {
            "Float64" => self.values(file, array, f64::from_le_bytes),
            "Float32" => self.values(file, array, |bytes| f64::from(f32::from_le_bytes(bytes))),
            other => Err(file.fault(array, "`Float64` or `Float32`", quoted(other.as_bytes()))),
        }
    }

    pub(super) fn integers<'a>(&self, file: &File<'a>, array: Node<'a, 'a>) -> Result<Vec<i64>, ParseError> {
        match file.attribute(array, "type")? {
            "Int64" => self.values(file, array, i64::from_le_bytes),
            "Int32" => self.values(file, array, |bytes| i32::from_le_bytes(bytes).into()),
            "UInt8" => self.values(file, array, |bytes| u8::from_le_bytes(bytes).into()),
            other => Err(file.fault(array, "`Int64`, `Int32` or `UInt8`", quoted(other.as_bytes()))),
        }
    }

    fn values<'a, T: FromStr, const N: usize>(
        &self,
        file: &File<'a>,
        array: Node<'a, 'a>,
        decode: fn([u8; N]) -> T,
    ) -> Result<Vec<T>, ParseError> {
        let text = array.text().unwrap_or_default();
        match file.attribute(array, "format")? {
            "ascii" => {
                let number = |word: &str| {
                    parse(word.as_bytes())
                        .ok_or_else(|| file.fault(array, "a number", quoted(word.as_bytes())))
                };
                text.split_ascii_whitespace().map(number).collect()
            }
            "binary" => {
                let bytes = STANDARD
                    .decode(text.trim_ascii())
                    .map_err(|error| file.fault(array, "base64", quoted(error.to_string().as_bytes())))?;
                let data = self
                    .body(&bytes)
                    .ok_or_else(|| file.fault(array, "as many bytes as the array begins with", "others"))?;
                let (numbers, rest) = data.as_chunks::<N>();
                if !rest.is_empty() {
                    return Err(file.fault(
                        array,
                        format!("numbers of {N} bytes"),
                        format!("{} bytes", data.len()),
                    ));
                }
                Ok(numbers
                    .iter()
                    .map(|&number| decode(self.little_endian(number)))
                    .collect())
            }
            other => Err(file.fault(array, "format `ascii` or `binary`", quoted(other.as_bytes()))),
        }
    }

    /// The bytes after the header, if their number is the one in the header.
    fn body<'b>(&self, bytes: &'b [u8]) -> Option<&'b [u8]> {
        let (header, body) = bytes.split_at_checked(self.header)?;
        let length = match header {
            &[a, b, c, d] => u32::from_le_bytes(self.little_endian([a, b, c, d])).into(),
            _ => u64::from_le_bytes(self.little_endian(header.try_into().ok()?)),
        };
        (length == body.len() as u64).then_some(body)
    }

    fn little_endian<const N: usize>(&self, mut bytes: [u8; N]) -> [u8; N] {
        if let ByteOrder::BigEndian = self.order {
            bytes.reverse();
        }
        bytes
    }
}
