//! Gmsh's MSH, versions 2.2 and 4.1, as text and binary: nodes, elements and physical
//! groups.
//!
//! Gmsh reference manual, *MSH file format* and *MSH file format version 2 (Legacy)*.

mod elements;
mod groups;
mod nodes;
mod values;

use super::binary::{ByteOrder, Bytes};
use super::budget::Budget;
use super::cells::Cells;
use super::text::{Lines, Syntax, expect};
use crate::error::{Fault, ParseError, quoted};
use groups::Groups;
use values::{BinaryValues, TextValues, Values, Version};

pub(super) fn read(bytes: &[u8], budget: &Budget) -> Result<Cells, ParseError> {
    const VERSION: &str = "`2.2` or `4.1`";
    const ENCODING: &str = "`0` for text or `1` for binary";
    const SIZE: &str = "`8`, the size of a number";
    let mut lines = Lines::new(bytes, Syntax::Plain, budget);
    expect(&mut lines.expect(|| "`$MeshFormat`".to_owned())?, "$MeshFormat")?;
    let line = &mut lines.expect(|| "the version, the encoding and the size of a number".to_owned())?;
    let version = match line.expect_word(VERSION)? {
        b"2.2" => Version::V2,
        b"4.1" => Version::V4,
        other => return Err(line.unexpected(VERSION, other)),
    };
    let is_binary = match line.expect_word(ENCODING)? {
        b"0" => false,
        b"1" => true,
        other => return Err(line.unexpected(ENCODING, other)),
    };
    let size = line.expect_word(SIZE)?;
    if is_binary && size != b"8" {
        return Err(line.unexpected(SIZE, size));
    }
    line.expect_end()?;
    let groups = Groups::new(budget);
    if is_binary {
        let mut body = Bytes::new(bytes, bytes.len() - lines.rest().len(), budget);
        let order = byte_order(&mut body)?;
        read_sections(version, BinaryValues::new(body, order), groups)
    } else {
        read_sections(version, TextValues::new(lines), groups)
    }
}

/// The byte order in which the next number is 1.
fn byte_order(bytes: &mut Bytes) -> Result<ByteOrder, ParseError> {
    const ONE: &str = "the number 1 in four bytes";
    let place = bytes.place();
    match bytes.array(|| ONE.to_owned())? {
        [1, 0, 0, 0] => Ok(ByteOrder::LittleEndian),
        [0, 0, 0, 1] => Ok(ByteOrder::BigEndian),
        other => Err(Fault::expected(ONE, format!("{other:?}")).at(place)),
    }
}

/// Reads all sections after the version. Sections other than nodes, elements and physical groups are skipped.
fn read_sections<'a>(
    version: Version,
    mut values: impl Values<'a>,
    mut groups: Groups<'_>,
) -> Result<Cells, ParseError> {
    values.skip_to("$EndMeshFormat")?;
    let mut cells = Cells::default();
    let mut nodes = None;
    let mut elements = false;
    while let Some((place, section)) = values.section() {
        let unexpected = |expected: &str| Err(Fault::expected(expected, quoted(section)).at(place));
        match (section, &nodes) {
            (b"$Nodes", None) => {
                let read = nodes::read(version, &mut values)?;
                read.tags.charge(groups.budget());
                cells.positions = read.positions;
                nodes = Some(read.tags);
            }
            (b"$Elements", Some(tags)) if !elements => {
                elements::read(version, &mut values, tags, &mut cells, &mut groups)?;
                elements = true;
            }
            (b"$Elements", None) => return unexpected("`$Nodes` before the elements"),
            (b"$Nodes" | b"$Elements", _) => return unexpected("a section of which there is no other"),
            (b"$PhysicalNames", _) => groups.read_names(&mut values)?,
            (b"$Entities", _) if version == Version::V4 => {
                if elements {
                    return unexpected("`$Entities` before the elements");
                }
                groups.read_entities(&mut values)?;
            }
            // Without another `$`, no two places where the end may begin overlap: its search is linear.
            ([b'$', name @ ..], _) if name.iter().all(u8::is_ascii_alphanumeric) => {
                let name = String::from_utf8_lossy(name);
                values.skip_to(&format!("$End{name}"))?;
            }
            _ => return unexpected("a section such as `$Nodes`"),
        }
    }
    for (is_there, section) in [(nodes.is_some(), "`$Nodes`"), (elements, "`$Elements`")] {
        if !is_there {
            return Err(Fault::ends(section).at(values.place()));
        }
    }
    cells.groups = groups.finish(cells.positions.len());
    Ok(cells)
}
