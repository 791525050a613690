//! The header of a PLY file: the elements that follow and the properties of their rows.

use std::collections::HashSet;

use super::super::binary::ByteOrder;
use super::super::budget::Budget;
use super::super::text::{Line, Lines, expect};
use crate::error::{ParseError, Place};
use crate::named_part::NamedPart;

pub(super) struct Header<'a> {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element<'a>>,
    /// The parts that comments name.
    pub(super) parts: Vec<NamedPart>,
}

#[derive(Clone, Copy)]
pub(super) enum Encoding {
    Text,
    Binary(ByteOrder),
}

/// A table: `count` rows of these properties.
pub(super) struct Element<'a> {
    pub(super) name: &'a [u8],
    pub(super) count: u64,
    pub(super) properties: Vec<Property<'a>>,
    /// The place of its declaration in the header.
    pub(super) place: Place,
}

pub(super) struct Property<'a> {
    pub(super) name: &'a [u8],
    pub(super) kind: Kind,
}

#[derive(Clone, Copy)]
pub(super) enum Kind {
    One(Scalar),
    List { count: Integer, item: Scalar },
}

#[derive(Clone, Copy)]
pub(super) enum Scalar {
    Integer(Integer),
    Float32,
    Float64,
}

#[derive(Clone, Copy)]
pub(super) enum Integer {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
}

impl Scalar {
    /// Its size in a binary file, in bytes.
    pub(super) fn size(self) -> u64 {
        match self {
            Self::Integer(Integer::I8 | Integer::U8) => 1,
            Self::Integer(Integer::I16 | Integer::U16) => 2,
            Self::Integer(Integer::I32 | Integer::U32) | Self::Float32 => 4,
            Self::Float64 => 8,
        }
    }
}

impl<'a> Header<'a> {
    /// Reads all lines up to and including `end_header`.
    pub(super) fn read(lines: &mut Lines<'a>, budget: &Budget) -> Result<Self, ParseError> {
        const STATEMENT: &str = "`format`, `comment`, `element`, `property` or `end_header`";
        let mut magic = lines.expect(|| "`ply`".to_owned())?;
        expect(&mut magic, "ply")?;
        magic.expect_end()?;

        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        let mut names = HashSet::new();
        let mut parts = Vec::new();
        loop {
            let line = &mut lines.expect(|| "`end_header`".to_owned())?;
            match line.expect_word(STATEMENT)? {
                b"comment" => {
                    if let Some(part) = NamedPart::parse(line.rest()) {
                        budget.hold::<NamedPart>(1);
                        parts.push(part);
                    }
                    continue;
                }
                b"obj_info" => continue,
                b"format" => encoding = Some(read_encoding(line)?),
                b"element" => {
                    let element = read_element(line)?;
                    if !names.insert((None, element.name)) {
                        return Err(line.unexpected("an element with a name of its own", element.name));
                    }
                    budget.hold::<Element>(1);
                    elements.push(element);
                }
                b"property" => {
                    let property = read_property(line)?;
                    budget.hold::<Property>(1);
                    if !names.insert((Some(elements.len()), property.name)) {
                        return Err(line.unexpected("a property with a name of its own", property.name));
                    }
                    let element = elements.last_mut();
                    element
                        .ok_or_else(|| line.unexpected("`element`", b"property"))?
                        .properties
                        .push(property);
                }
                b"end_header" => {
                    line.expect_end()?;
                    let encoding = encoding.ok_or_else(|| line.unexpected("`format`", b"end_header"))?;
                    return Ok(Self {
                        encoding,
                        elements,
                        parts,
                    });
                }
                other => return Err(line.unexpected(STATEMENT, other)),
            }
            line.expect_end()?;
        }
    }
}

fn read_encoding(line: &mut Line) -> Result<Encoding, ParseError> {
    const ENCODING: &str = "`ascii`, `binary_little_endian` or `binary_big_endian`";
    let encoding = match line.expect_word(ENCODING)? {
        b"ascii" => Encoding::Text,
        b"binary_little_endian" => Encoding::Binary(ByteOrder::LittleEndian),
        b"binary_big_endian" => Encoding::Binary(ByteOrder::BigEndian),
        other => return Err(line.unexpected(ENCODING, other)),
    };
    expect(line, "1.0")?;
    Ok(encoding)
}

fn read_element<'a>(line: &mut Line<'a>) -> Result<Element<'a>, ParseError> {
    Ok(Element {
        name: line.expect_word("the name of an element")?,
        count: line.count("the number of rows")?,
        properties: Vec::new(),
        place: line.place(),
    })
}

fn read_property<'a>(line: &mut Line<'a>) -> Result<Property<'a>, ParseError> {
    let kind = match line.expect_word(TYPE)? {
        b"list" => Kind::List {
            count: match read_scalar(line)? {
                (Scalar::Integer(count), _) => count,
                (_, word) => return Err(line.unexpected("a type of integers", word)),
            },
            item: read_scalar(line)?.0,
        },
        word => Kind::One(scalar(line, word)?),
    };
    let name = line.expect_word("the name of a property")?;
    Ok(Property { name, kind })
}

const TYPE: &str = "a type such as `int`, `float` or `double`";

fn read_scalar<'a>(line: &mut Line<'a>) -> Result<(Scalar, &'a [u8]), ParseError> {
    let word = line.expect_word(TYPE)?;
    Ok((scalar(line, word)?, word))
}

fn scalar(line: &Line, word: &[u8]) -> Result<Scalar, ParseError> {
    Ok(match word {
        b"char" | b"int8" => Scalar::Integer(Integer::I8),
        b"uchar" | b"uint8" => Scalar::Integer(Integer::U8),
        b"short" | b"int16" => Scalar::Integer(Integer::I16),
        b"ushort" | b"uint16" => Scalar::Integer(Integer::U16),
        b"int" | b"int32" => Scalar::Integer(Integer::I32),
        b"uint" | b"uint32" => Scalar::Integer(Integer::U32),
        b"float" | b"float32" => Scalar::Float32,
        b"double" | b"float64" => Scalar::Float64,
        other => return Err(line.unexpected(TYPE, other)),
    })
}
