//! Arrays of numbers: inline as text or in base64, or appended to the file.

use std::borrow::Cow;

use roxmltree::Node;

use super::super::budget::Budget;
use super::super::scalar::{ByteOrder, Scalar};
use super::super::tokens::{Number, Syntax, Tokens};
use super::blocks::{Compression, Layout};
use super::stream::Stream;
use super::xml::File;
use crate::error::{ParseError, quoted};

/// The encoding of the arrays of a file.
pub(super) struct Encoding<'a> {
    layout: Layout,
    appended: Option<Appended<'a>>,
    budget: &'a Budget,
}

/// The data after the XML.
struct Appended<'a> {
    data: &'a [u8],
    is_raw: bool,
}

const INTEGER: &str = "`Int8` to `UInt64`";
const REAL: &str = "`Float32`, `Float64` or a type of integers";

impl<'a> Encoding<'a> {
    /// The encoding that the root of a file describes, with the data after the XML.
    pub(super) fn of<'n>(
        file: &File<'n>,
        appended: Option<&'a [u8]>,
        budget: &'a Budget,
    ) -> Result<Self, ParseError> {
        let root = file.root;
        let unexpected =
            |expected: &str, found: &str| Err(file.fault(root, expected, quoted(found.as_bytes())));
        let compression = match root.attribute("compressor") {
            None | Some("") => None,
            Some("vtkZLibDataCompressor") => Some(Compression::Zlib),
            Some("vtkLZ4DataCompressor") => Some(Compression::Lz4),
            Some(found @ "vtkLZMADataCompressor") => {
                let expected = "data compressed by zlib, by LZ4 or not (save the file again: in ParaView with \
                                the compressor ZLib or LZ4, in VTK with SetCompressorTypeToZLib(), in pyvista \
                                with save(name, compression=\"zlib\"))";
                return unexpected(expected, found);
            }
            Some(other) => return unexpected("data compressed by zlib, by LZ4 or not", other),
        };
        let order = match file.attribute(root, "byte_order")? {
            "LittleEndian" => ByteOrder::LittleEndian,
            "BigEndian" => ByteOrder::BigEndian,
            other => return unexpected("`LittleEndian` or `BigEndian`", other),
        };
        let word = match root.attribute("header_type") {
            None | Some("UInt32") => Scalar::U32,
            Some("UInt64") => Scalar::U64,
            Some(other) => return unexpected("`UInt32` or `UInt64`", other),
        };
        let appended = match appended {
            None => None,
            Some(data) => {
                let node = file.child(root, "AppendedData")?;
                let is_raw = match file.attribute(node, "encoding")? {
                    "raw" => true,
                    "base64" => false,
                    other => {
                        let found = quoted(other.as_bytes());
                        return Err(file.fault(node, "encoding `raw` or `base64`", found));
                    }
                };
                Some(Appended { data, is_raw })
            }
        };
        Ok(Self {
            layout: Layout {
                order,
                word,
                compression,
            },
            appended,
            budget,
        })
    }

    pub(super) fn reals<'n>(&self, file: &File<'n>, array: Node<'n, 'n>) -> Result<Vec<f64>, ParseError> {
        let scalar = scalar(file, array, REAL)?;
        self.values(file, array, scalar, |bytes| {
            scalar.reals(bytes, self.layout.order)
        })
    }

    pub(super) fn integers<'n>(&self, file: &File<'n>, array: Node<'n, 'n>) -> Result<Vec<i64>, ParseError> {
        let scalar = scalar(file, array, INTEGER)?;
        if !scalar.is_integer() {
            let found = quoted(file.attribute(array, "type")?.as_bytes());
            return Err(file.fault(array, INTEGER, found));
        }
        self.values(file, array, scalar, |bytes| {
            scalar.integers(bytes, self.layout.order)
        })
    }

    fn values<'n, T: Number>(
        &self,
        file: &File<'n>,
        array: Node<'n, 'n>,
        scalar: Scalar,
        decode: impl FnOnce(&[u8]) -> Vec<T>,
    ) -> Result<Vec<T>, ParseError> {
        let text = text(array);
        let (mut stream, is_inline) = match file.attribute(array, "format")? {
            "ascii" => {
                let mut tokens = Tokens::text(text.as_bytes(), Syntax::Free, self.budget);
                let numbers = tokens.numbers("a number");
                return numbers.map_err(|error| file.at(array, error.fault));
            }
            // An empty array may have no header.
            "binary" if text.trim_ascii().is_empty() => return Ok(Vec::new()),
            "binary" => (Stream::base64(text.as_bytes().trim_ascii()), true),
            "appended" => (self.appended_stream(file, array)?, false),
            other => {
                let found = quoted(other.as_bytes());
                return Err(file.fault(array, "format `ascii`, `binary` or `appended`", found));
            }
        };
        let data = self.layout.data(&mut stream, self.budget);
        let data = data.map_err(|fault| file.at(array, fault))?;
        if is_inline && !stream.is_empty() {
            let expected = format!("{} bytes, as the array begins with", data.len());
            return Err(file.fault(array, expected, "more"));
        }
        if data.len() % scalar.size() != 0 {
            let expected = format!("numbers of {} bytes", scalar.size());
            return Err(file.fault(array, expected, format!("{} bytes", data.len())));
        }
        self.budget.hold::<T>(data.len() / scalar.size());
        Ok(decode(&data))
    }

    /// The appended data from the offset of an array on.
    fn appended_stream<'n>(&self, file: &File<'n>, array: Node<'n, 'n>) -> Result<Stream<'a>, ParseError> {
        let offset = file.attribute(array, "offset")?;
        let missing = || {
            let found = format!("offset {}", quoted(offset.as_bytes()));
            file.fault(array, "an offset into the appended data", found)
        };
        let appended = self.appended.as_ref().ok_or_else(missing)?;
        let data = offset.parse::<usize>().ok();
        let data = data.and_then(|offset| appended.data.get(offset..));
        let data = data.ok_or_else(missing)?;
        Ok(if appended.is_raw {
            Stream::Raw(data)
        } else {
            Stream::base64(data)
        })
    }
}

/// The text of an array, which comments and other elements may interrupt.
fn text<'n>(array: Node<'n, 'n>) -> Cow<'n, str> {
    let mut pieces = array
        .children()
        .filter(Node::is_text)
        .filter_map(|node| node.text());
    let first = pieces.next().unwrap_or_default();
    match pieces.next() {
        None => Cow::Borrowed(first),
        Some(second) => Cow::Owned([first, second].into_iter().chain(pieces).collect()),
    }
}

/// The type of the numbers of an array.
fn scalar<'n>(file: &File<'n>, array: Node<'n, 'n>, expected: &str) -> Result<Scalar, ParseError> {
    let name = file.attribute(array, "type")?;
    let scalar = Scalar::named(name.to_ascii_lowercase().as_bytes());
    scalar.ok_or_else(|| file.fault(array, expected, quoted(name.as_bytes())))
}
