//! Gmsh's MSH, versions 1, 2 to 2.2, 4 and 4.1, as text and binary: nodes, elements and physical groups.
//!
//! Gmsh reference manual, *MSH file format*, and the same of versions 1 and 2 (*Legacy*); of version 4.0, the
//! manual of Gmsh 4.0.

mod elements;
mod groups;
mod nodes;

use super::budget::Budget;
use super::cells::Cells;
use super::scalar::{ByteOrder, Scalar};
use super::tokens::{Encoding, Syntax, Tokens};
use crate::error::{Fault, ParseError, quoted};
use crate::note::Fact;
use groups::Groups;

/// The types of numbers: `int` and `double`. Others are of the type `size_t`.
const INT: Scalar = Scalar::I32;
const DOUBLE: Scalar = Scalar::F64;

/// The version of the format.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Version {
    /// Text only, without a header.
    V1,
    /// 2 to 2.2, which differ in what is not read.
    V2,
    V40,
    V41,
}

pub(super) fn read(bytes: &[u8], budget: &Budget) -> Result<Cells, ParseError> {
    let mut tokens = Tokens::text(bytes, Syntax::Lines, budget);
    let mut ahead = tokens.clone();
    if ahead.next_line() && ahead.next_is("$NOD") {
        return read_sections(Version::V1, &mut tokens);
    }
    tokens.expect_line(|| "`$MeshFormat`".to_owned())?;
    tokens.keyword("$MeshFormat")?;
    let version = read_format(&mut tokens)?;
    tokens.skip_to("$EndMeshFormat")?;
    read_sections(version, &mut tokens)
}

/// Reads the contents of the section `$MeshFormat`.
fn read_format(tokens: &mut Tokens) -> Result<Version, ParseError> {
    const VERSION: &str = "version 1, 2, 2.2, 4 or 4.1 (save it with gmsh -save -format msh41)";
    const ENCODING: &str = "`0` for text or `1` for binary";
    const SIZE: &str = "`8`, the size of a number";
    tokens.expect_line(|| "the version, the encoding and the size of a number".to_owned())?;
    let version = match tokens.expect_word(VERSION)? {
        b"2" | b"2.0" | b"2.1" | b"2.2" => Version::V2,
        b"4" | b"4.0" => Version::V40,
        b"4.1" => Version::V41,
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
        set_byte_order(tokens)?;
    }
    Ok(version)
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
    let mut groups = Groups::new(tokens.budget());
    let mut cells = Cells::default();
    let mut nodes = None;
    let mut elements = false;
    while tokens.next_line() {
        let section = tokens.word().unwrap_or_default();
        let place = tokens.place();
        let unexpected = |expected: &str| Err(Fault::expected(expected, quoted(section)).at(place));
        match (section, &nodes) {
            (b"$Nodes" | b"$NOD", None) => {
                let read = nodes::read(version, tokens)?;
                read.tags.charge(tokens.budget());
                cells.positions = read.positions;
                nodes = Some(read.tags);
            }
            (b"$Elements" | b"$ELM", Some(tags)) if !elements => {
                elements::read(version, tokens, tags, &mut cells, &mut groups)?;
                elements = true;
            }
            (b"$Elements" | b"$ELM", None) => return unexpected("`$Nodes` before the elements"),
            (b"$Nodes" | b"$NOD" | b"$Elements" | b"$ELM", _) => {
                return unexpected("a section of which there is no other");
            }
            (b"$PhysicalNames", _) => groups.read_names(tokens)?,
            (b"$Entities", _) if matches!(version, Version::V40 | Version::V41) => {
                if elements {
                    return unexpected("`$Entities` before the elements");
                }
                groups.read_entities(version, tokens)?;
            }
            // Without another `$`, no two places where the end may begin overlap: its search is linear.
            ([b'$', name @ ..], _) if name.iter().all(u8::is_ascii_alphanumeric) => {
                if name == b"NodeData" {
                    let remedy = "if it has displacements, add them to the positions (in Gmsh: Plugin(Warp))";
                    cells
                        .notes
                        .push(Fact::not_read("the section `$NodeData`", remedy).at(place));
                }
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
