//! Gmsh's MSH, versions 2.2 and 4.1, as text and binary: nodes, elements and physical
//! groups.
//!
//! Gmsh reference manual, *MSH file format* and *MSH file format version 2 (Legacy)*.

mod elements;
mod groups;
mod nodes;

use super::budget::Budget;
use super::cells::Cells;
use super::scalar::{ByteOrder, Scalar};
use super::tokens::{Encoding, Syntax, Tokens};
use crate::error::{Fault, ParseError, quoted};
use groups::Groups;

/// The types of numbers: `int` and `double`. Others are of the type `size_t`.
const INT: Scalar = Scalar::I32;
const DOUBLE: Scalar = Scalar::F64;

/// The version of the format.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Version {
    V2,
    V4,
}

pub(super) fn read(bytes: &[u8], budget: &Budget) -> Result<Cells, ParseError> {
    const VERSION: &str = "`2.2` or `4.1`";
    const ENCODING: &str = "`0` for text or `1` for binary";
    const SIZE: &str = "`8`, the size of a number";
    let mut tokens = Tokens::text(bytes, Syntax::Lines, budget);
    tokens.expect_line(|| "`$MeshFormat`".to_owned())?;
    tokens.keyword("$MeshFormat")?;
    tokens.expect_line(|| "the version, the encoding and the size of a number".to_owned())?;
    let version = match tokens.expect_word(VERSION)? {
        b"2.2" => Version::V2,
        b"4.1" => Version::V4,
        other => return Err(tokens.unexpected(VERSION, other)),
    };
    let is_binary = match tokens.expect_word(ENCODING)? {
        b"0" => false,
        b"1" => true,
        other => return Err(tokens.unexpected(ENCODING, other)),
    };
    let size = tokens.expect_word(SIZE)?;
    if is_binary && size != b"8" {
        return Err(tokens.unexpected(SIZE, size));
    }
    tokens.expect_line_end()?;
    if is_binary {
        set_byte_order(&mut tokens)?;
    }
    read_sections(version, &mut tokens)
}

/// Numbers are binary, in the byte order in which the next one is 1.
fn set_byte_order(tokens: &mut Tokens) -> Result<(), ParseError> {
    const ONE: &str = "the number 1 in four bytes";
    tokens.set_encoding(Encoding::Binary(ByteOrder::LittleEndian));
    let order = match tokens.array(|| ONE.to_owned())? {
        [1, 0, 0, 0] => ByteOrder::LittleEndian,
        [0, 0, 0, 1] => ByteOrder::BigEndian,
        other => return Err(Fault::expected(ONE, format!("{other:?}")).at(tokens.place())),
    };
    tokens.set_encoding(Encoding::Binary(order));
    Ok(())
}

/// Reads all sections after the version. Sections other than nodes, elements and physical groups are skipped.
fn read_sections(version: Version, tokens: &mut Tokens) -> Result<Cells, ParseError> {
    tokens.skip_to("$EndMeshFormat")?;
    let mut groups = Groups::new(tokens.budget());
    let mut cells = Cells::default();
    let mut nodes = None;
    let mut elements = false;
    while tokens.next_line() {
        let section = tokens.word().unwrap_or_default();
        let place = tokens.place();
        let unexpected = |expected: &str| Err(Fault::expected(expected, quoted(section)).at(place));
        match (section, &nodes) {
            (b"$Nodes", None) => {
                let read = nodes::read(version, tokens)?;
                read.tags.charge(tokens.budget());
                cells.positions = read.positions;
                nodes = Some(read.tags);
            }
            (b"$Elements", Some(tags)) if !elements => {
                elements::read(version, tokens, tags, &mut cells, &mut groups)?;
                elements = true;
            }
            (b"$Elements", None) => return unexpected("`$Nodes` before the elements"),
            (b"$Nodes" | b"$Elements", _) => return unexpected("a section of which there is no other"),
            (b"$PhysicalNames", _) => groups.read_names(tokens)?,
            (b"$Entities", _) if version == Version::V4 => {
                if elements {
                    return unexpected("`$Entities` before the elements");
                }
                groups.read_entities(tokens)?;
            }
            // Without another `$`, no two places where the end may begin overlap: its search is linear.
            ([b'$', name @ ..], _) if name.iter().all(u8::is_ascii_alphanumeric) => {
                let name = String::from_utf8_lossy(name);
                tokens.skip_to(&format!("$End{name}"))?;
            }
            _ => return unexpected("a section such as `$Nodes`"),
        }
    }
    for (is_there, section) in [(nodes.is_some(), "`$Nodes`"), (elements, "`$Elements`")] {
        if !is_there {
            return Err(tokens.ends(section));
        }
    }
    cells.groups = groups.finish(cells.positions.len());
    Ok(cells)
}
