//! The header of a PLY file: the elements that follow and the properties of their rows.

use std::collections::HashSet;

use super::super::scalar::{ByteOrder, Scalar};
use super::super::tokens::{Encoding, Tokens};
use crate::error::{ParseError, Place};
use crate::named_part::NamedPart;

pub(super) struct Header<'a> {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element<'a>>,
    /// The place of its last line.
    pub(super) end: Place,
    /// The parts that comments name.
    pub(super) parts: Vec<NamedPart>,
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
    pub(super) kind: PropertyType,
}

#[derive(Clone, Copy)]
pub(super) enum PropertyType {
    One(Scalar),
    /// A number of items, an integer of the first type, and the items.
    List {
        count: Scalar,
        item: Scalar,
    },
}

impl<'a> Header<'a> {
    /// Reads all lines up to and including `end_header`.
    pub(super) fn read(tokens: &mut Tokens<'a>) -> Result<Self, ParseError> {
        const STATEMENT: &str = "`format`, `comment`, `element`, `property` or `end_header`";
        let budget = tokens.budget();
        tokens.expect_line_of("ply")?;

        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        let mut names = HashSet::new();
        let mut parts = Vec::new();
        loop {
            tokens.expect_line(|| "`end_header`".to_owned())?;
            match tokens.expect_word(STATEMENT)? {
                b"comment" => {
                    if let Some(part) = NamedPart::parse(tokens.rest_of_line()) {
                        budget.hold::<NamedPart>(1);
                        parts.push(part);
                    }
                    continue;
                }
                b"obj_info" => continue,
                b"format" => encoding = Some(read_encoding(tokens)?),
                b"element" => {
                    let element = read_element(tokens)?;
                    if !names.insert((None, element.name)) {
                        return Err(tokens.unexpected("an element with a name of its own", element.name));
                    }
                    budget.hold::<Element>(1);
                    elements.push(element);
                }
                b"property" => {
                    let property = read_property(tokens)?;
                    budget.hold::<Property>(1);
                    if !names.insert((Some(elements.len()), property.name)) {
                        return Err(tokens.unexpected("a property with a name of its own", property.name));
                    }
                    let element = elements.last_mut();
                    element
                        .ok_or_else(|| tokens.unexpected("`element`", b"property"))?
                        .properties
                        .push(property);
                }
                b"end_header" => {
                    tokens.expect_line_end()?;
                    let encoding = encoding.ok_or_else(|| tokens.unexpected("`format`", b"end_header"))?;
                    return Ok(Self {
                        encoding,
                        elements,
                        end: tokens.place(),
                        parts,
                    });
                }
                other => return Err(tokens.unexpected(STATEMENT, other)),
            }
            tokens.expect_line_end()?;
        }
    }
}

fn read_encoding(tokens: &mut Tokens) -> Result<Encoding, ParseError> {
    const ENCODING: &str = "`ascii`, `binary_little_endian` or `binary_big_endian`";
    let encoding = match tokens.expect_word(ENCODING)? {
        b"ascii" => Encoding::Text,
        b"binary_little_endian" => Encoding::Binary(ByteOrder::LittleEndian),
        b"binary_big_endian" => Encoding::Binary(ByteOrder::BigEndian),
        other => return Err(tokens.unexpected(ENCODING, other)),
    };
    tokens.keyword("1.0")?;
    Ok(encoding)
}

fn read_element<'a>(tokens: &mut Tokens<'a>) -> Result<Element<'a>, ParseError> {
    Ok(Element {
        name: tokens.expect_word("the name of an element")?,
        count: tokens.count("the number of rows")?,
        properties: Vec::new(),
        place: tokens.place(),
    })
}

fn read_property<'a>(tokens: &mut Tokens<'a>) -> Result<Property<'a>, ParseError> {
    let kind = match tokens.expect_word(TYPE)? {
        b"list" => {
            let word = tokens.expect_word(TYPE)?;
            let count = scalar(tokens, word)?;
            if !count.is_integer() {
                return Err(tokens.unexpected("a type of integers", word));
            }
            let item = tokens.expect_word(TYPE)?;
            let item = scalar(tokens, item)?;
            PropertyType::List { count, item }
        }
        word => PropertyType::One(scalar(tokens, word)?),
    };
    let name = tokens.expect_word("the name of a property")?;
    Ok(Property { name, kind })
}

const TYPE: &str = "a type such as `int`, `float` or `double`";

fn scalar(tokens: &Tokens, word: &[u8]) -> Result<Scalar, ParseError> {
    Scalar::named(word).ok_or_else(|| tokens.unexpected(TYPE, word))
}
