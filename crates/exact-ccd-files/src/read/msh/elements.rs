//! The section `$Elements`.

use arrayvec::ArrayVec;

use super::super::cells::Cells;
use super::super::record::Record;
use super::super::solids::Solid;
use super::super::tokens::Tokens;
use super::groups::Groups;
use super::nodes::{Tags, count_line, entity, positive_tag};
use super::{INT, Version};
use crate::error::{Fault, ParseError};

/// A supported type of elements.
///
/// Points and lines are rarely elements of a body: Gmsh writes them for the corners and edges of the
/// geometry.
#[derive(Clone, Copy)]
struct Shape {
    dimension: u8,
    corners: usize,
}

impl Shape {
    fn read(tokens: &mut Tokens, expected: &str) -> Result<Self, ParseError> {
        let (dimension, corners) = match tokens.integer(INT, expected)? {
            15 => (0, 1),
            1 => (1, 2),
            2 => (2, 3),
            3 => (2, 4),
            4 => (3, 4),
            5 => (3, 8),
            6 => (3, 6),
            7 => (3, 5),
            number => {
                let expected = "an element of first order, of type 1 to 7 or 15 (save the mesh again with \
                                gmsh -order 1 -save)";
                return Err(Fault::expected(expected, format!("`{number}`")).at(tokens.place()));
            }
        };
        Ok(Self { dimension, corners })
    }
}

/// A reader that appends elements to cells.
struct Elements<'a, 'b> {
    tags: &'a Tags,
    cells: &'a mut Cells,
    groups: &'a mut Groups<'b>,
}

pub(super) fn read(
    version: Version,
    tokens: &mut Tokens,
    tags: &Tags,
    cells: &mut Cells,
    groups: &mut Groups<'_>,
) -> Result<(), ParseError> {
    let mut elements = Elements { tags, cells, groups };
    match version {
        Version::V1 => elements.read_v1(tokens)?,
        Version::V2 => elements.read_v2(tokens)?,
        Version::V40 | Version::V41 => elements.read_blocks(version, tokens)?,
    }
    tokens.expect_line_of(if version == Version::V1 {
        "$ENDELM"
    } else {
        "$EndElements"
    })
}

impl Elements<'_, '_> {
    /// Reads elements one by one, each with its tag, type, the tags of its physical group and of its entity,
    /// and the number of its nodes.
    fn read_v1(&mut self, tokens: &mut Tokens) -> Result<(), ParseError> {
        let count = count_line(tokens, "the number of elements")?;
        for number in 0..count {
            tokens.begin(Record::of("element", number, count))?;
            tokens.integer(INT, "the tag of an element")?;
            let shape = Shape::read(tokens, "the type of an element")?;
            let physical = tokens.integer(INT, "the tag of a physical group")?;
            self.groups.set_tag(Some((physical, tokens.place())))?;
            tokens.integer(INT, "the tag of an entity")?;
            let nodes = tokens.integer(INT, "the number of nodes")?;
            if nodes != shape.corners as i64 {
                let expected = format!("{} nodes", shape.corners);
                return Err(Fault::expected(expected, format!("`{nodes}`")).at(tokens.place()));
            }
            self.add(tokens, shape, positive_tag)?;
            tokens.end()?;
        }
        Ok(())
    }

    /// Reads elements one by one, each with its type; in binary files, in blocks of consecutive
    /// elements of one type.
    fn read_v2(&mut self, tokens: &mut Tokens) -> Result<(), ParseError> {
        let count = count_line(tokens, "the number of elements")?;
        let mut number = 0;
        while number < count {
            tokens.begin(Record::of("element", number, count))?;
            if tokens.is_binary() {
                let shape = Shape::read(tokens, "the type of an element")?;
                let in_block = tokens.integer(INT, "the number of elements in the block")?;
                let left = count - number;
                let in_block = u64::try_from(in_block)
                    .ok()
                    .filter(|&n| n <= left)
                    .ok_or_else(|| {
                        Fault::expected(
                            format!("a block of at most {left} elements"),
                            format!("`{in_block}`"),
                        )
                        .at(tokens.place())
                    })?;
                let tag_count = tokens.integer(INT, "the number of tags")?;
                for element in number..number + in_block {
                    tokens.begin(Record::of("element", element, count))?;
                    tokens.integer(INT, "the tag of an element")?;
                    self.read_tags_and_nodes(tokens, shape, tag_count)?;
                }
                number += in_block;
            } else {
                tokens.integer(INT, "the tag of an element")?;
                let shape = Shape::read(tokens, "the type of an element")?;
                let tag_count = tokens.integer(INT, "the number of tags")?;
                self.read_tags_and_nodes(tokens, shape, tag_count)?;
                tokens.end()?;
                number += 1;
            }
        }
        Ok(())
    }

    fn read_tags_and_nodes(
        &mut self,
        tokens: &mut Tokens,
        shape: Shape,
        tag_count: i64,
    ) -> Result<(), ParseError> {
        let mut physical = None;
        for number in 0..tag_count {
            let tag = tokens.integer(INT, "a tag")?;
            // The first tag is that of the physical group.
            if number == 0 {
                physical = Some((tag, tokens.place()));
            }
        }
        self.groups.set_tag(physical)?;
        self.add(tokens, shape, positive_tag)
    }

    /// Reads elements in blocks of one type, one for each entity of the geometry.
    fn read_blocks(&mut self, version: Version, tokens: &mut Tokens) -> Result<(), ParseError> {
        tokens.begin(Record::one("the numbers of blocks and elements"))?;
        let blocks = tokens.size("the number of blocks")?;
        let count = tokens.size("the number of elements")?;
        let count_place = tokens.place();
        if version == Version::V41 {
            tokens.size("the least tag of an element")?;
            tokens.size("the greatest tag of an element")?;
        }
        tokens.end()?;
        let mut found = 0_u64;
        for block in 0..blocks {
            tokens.begin(Record::of("element block", block, blocks))?;
            let [dimension, tag] = entity(version, tokens)?;
            self.groups.set_entity(dimension, tag);
            let shape = Shape::read(tokens, "the type of the elements")?;
            let in_block = tokens.size("the number of elements in the block")?;
            tokens.end()?;
            for number in 0..in_block {
                tokens.begin(Record::of("element", number, in_block))?;
                if version == Version::V41 {
                    tokens.size("the tag of an element")?;
                    self.add(tokens, shape, |tokens| tokens.size("the tag of a node"))?;
                } else {
                    tokens.integer(INT, "the tag of an element")?;
                    self.add(tokens, shape, positive_tag)?;
                }
                tokens.end()?;
                found += 1;
            }
        }
        if found == count {
            return Ok(());
        }
        Err(Fault::expected(format!("{count} elements"), found.to_string()).at(count_place))
    }

    /// Reads the tags of the nodes of an element and appends the element.
    fn add(
        &mut self,
        tokens: &mut Tokens,
        shape: Shape,
        tag: impl Fn(&mut Tokens) -> Result<u64, ParseError>,
    ) -> Result<(), ParseError> {
        // No shape has more corners.
        let mut corners: ArrayVec<u32, 8> = ArrayVec::new();
        for _ in 0..shape.corners {
            let tag = tag(tokens)?;
            let node = self.tags.get(tag).ok_or_else(|| {
                let expected = format!("the tag of one of the {} nodes", self.tags.count());
                Fault::expected(expected, format!("`{tag}`")).at(tokens.place())
            })?;
            corners.push(node);
        }
        let (cells, place) = (&mut *self.cells, tokens.place());
        let cell = (shape.dimension == 3).then_some(cells.solids.len() as u32);
        match shape.dimension {
            0 => cells.points.extend(&corners),
            1 => cells.add_polyline(&corners),
            2 => cells.faces.add(&corners, || place)?,
            _ => cells.solids.extend(Solid::of(&corners)),
        }
        self.groups.add(shape.dimension, &corners, cell, place)
    }
}
