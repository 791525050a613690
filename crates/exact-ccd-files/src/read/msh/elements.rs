//! The section `$Elements`.

use arrayvec::ArrayVec;

use super::super::cells::Cells;
use super::super::solids::Solid;
use super::groups::Groups;
use super::nodes::{Tags, positive};
use super::values::{Record, Values, Version};
use crate::error::{Fault, ParseError, Place};

/// The supported types of elements.
///
/// Points and lines are rarely elements of a body: Gmsh writes them for the corners and edges of
/// the geometry.
#[derive(Clone, Copy)]
enum Shape {
    Point,
    Line,
    Triangle,
    Quadrilateral,
    Tetrahedron,
    Hexahedron,
    Wedge,
    Pyramid,
}

impl Shape {
    fn dimension(self) -> u8 {
        match self {
            Self::Point => 0,
            Self::Line => 1,
            Self::Triangle | Self::Quadrilateral => 2,
            Self::Tetrahedron | Self::Hexahedron | Self::Wedge | Self::Pyramid => 3,
        }
    }

    fn of_type(number: i64, place: Place) -> Result<Self, ParseError> {
        match number {
            15 => Ok(Self::Point),
            1 => Ok(Self::Line),
            2 => Ok(Self::Triangle),
            3 => Ok(Self::Quadrilateral),
            4 => Ok(Self::Tetrahedron),
            5 => Ok(Self::Hexahedron),
            6 => Ok(Self::Wedge),
            7 => Ok(Self::Pyramid),
            _ => {
                let expected = "an element of first order, of type 1 to 7 or 15";
                Err(Fault::expected(expected, format!("`{number}`")).at(place))
            }
        }
    }
}

/// A reader that appends elements to cells.
struct Elements<'a, 'b> {
    tags: &'a Tags,
    cells: &'a mut Cells,
    groups: &'a mut Groups<'b>,
}

pub(super) fn read<'a>(
    version: Version,
    values: &mut impl Values<'a>,
    tags: &Tags,
    cells: &mut Cells,
    groups: &mut Groups<'_>,
) -> Result<(), ParseError> {
    let mut elements = Elements { tags, cells, groups };
    match version {
        Version::V2 => elements.read_v2(values)?,
        Version::V4 => elements.read_v4(values)?,
    }
    values.end_section("$EndElements")
}

impl Elements<'_, '_> {
    /// Reads elements one by one, each with its type; in binary files, in blocks of consecutive
    /// elements of one type.
    fn read_v2<'a, V: Values<'a>>(&mut self, values: &mut V) -> Result<(), ParseError> {
        let count = values.count_line("the number of elements")?;
        let mut number = 0;
        while number < count {
            let record = Record::of("element", number, count);
            values.begin(record)?;
            let place = values.place();
            if V::BINARY {
                let shape = Shape::of_type(values.int("the type of an element")?, place)?;
                let in_block = values.int("the number of elements in the block")?;
                let left = count - number;
                let in_block = u64::try_from(in_block)
                    .ok()
                    .filter(|&n| n <= left)
                    .ok_or_else(|| {
                        Fault::expected(
                            format!("a block of at most {left} elements"),
                            format!("`{in_block}`"),
                        )
                        .at(place)
                    })?;
                let tag_count = values.int("the number of tags")?;
                for element in number..number + in_block {
                    values.begin(Record::of("element", element, count))?;
                    values.int("the tag of an element")?;
                    self.read_tags_and_nodes(values, shape, tag_count)?;
                }
                number += in_block;
            } else {
                values.int("the tag of an element")?;
                let shape = Shape::of_type(values.int("the type of an element")?, place)?;
                let tag_count = values.int("the number of tags")?;
                self.read_tags_and_nodes(values, shape, tag_count)?;
                values.end()?;
                number += 1;
            }
        }
        Ok(())
    }

    fn read_tags_and_nodes<'a, V: Values<'a>>(
        &mut self,
        values: &mut V,
        shape: Shape,
        tag_count: i64,
    ) -> Result<(), ParseError> {
        let mut physical = None;
        for number in 0..tag_count {
            let place = values.place();
            let tag = values.int("a tag")?;
            // The first tag is that of the physical group.
            if number == 0 {
                physical = Some((tag, place));
            }
        }
        self.groups.set_tag(physical)?;
        self.add(values, shape, |values| {
            let place = values.place();
            positive(values.int("the tag of a node")?, place)
        })
    }

    /// Reads elements in blocks of one type, one for each entity of the geometry.
    fn read_v4<'a, V: Values<'a>>(&mut self, values: &mut V) -> Result<(), ParseError> {
        values.begin(Record::one("the numbers of blocks and elements"))?;
        let blocks = values.size("the number of blocks")?;
        let count_place = values.place();
        let count = values.size("the number of elements")?;
        values.size("the least tag of an element")?;
        values.size("the greatest tag of an element")?;
        values.end()?;
        let mut found = 0_u64;
        for block in 0..blocks {
            values.begin(Record::of("element block", block, blocks))?;
            let dimension = values.int("the dimension of an entity")?;
            self.groups
                .set_entity(dimension, values.int("the tag of an entity")?);
            let place = values.place();
            let shape = Shape::of_type(values.int("the type of the elements")?, place)?;
            let in_block = values.size("the number of elements in the block")?;
            values.end()?;
            for number in 0..in_block {
                values.begin(Record::of("element", number, in_block))?;
                values.size("the tag of an element")?;
                self.add(values, shape, |values| values.size("the tag of a node"))?;
                values.end()?;
                found += 1;
            }
        }
        if found == count {
            return Ok(());
        }
        Err(Fault::expected(format!("{count} elements"), found.to_string()).at(count_place))
    }

    /// Reads the tags of the nodes of an element and appends the element.
    fn add<'a, V: Values<'a>>(
        &mut self,
        values: &mut V,
        shape: Shape,
        mut tag: impl FnMut(&mut V) -> Result<u64, ParseError>,
    ) -> Result<(), ParseError> {
        let tags = self.tags;
        let begin = values.place();
        // No shape has more corners.
        let mut corners: ArrayVec<u32, 8> = ArrayVec::new();
        let mut node = || {
            let place = values.place();
            let tag = tag(values)?;
            let node = tags.get(tag).ok_or_else(|| {
                let expected = format!("the tag of one of the {} nodes", tags.count());
                Fault::expected(expected, format!("`{tag}`")).at(place)
            })?;
            corners.push(node);
            Ok(node)
        };
        let cell = (shape.dimension() == 3).then_some(self.cells.solids.len() as u32);
        match shape {
            Shape::Point => self.cells.points.push(node()?),
            Shape::Line => self.cells.lines.push([node()?, node()?]),
            Shape::Triangle => self.cells.faces.add(&nodes::<3>(node)?, || begin)?,
            Shape::Quadrilateral => self.cells.faces.add(&nodes::<4>(node)?, || begin)?,
            Shape::Tetrahedron => self.cells.solids.push(Solid::Tetrahedron(nodes(node)?)),
            Shape::Hexahedron => self.cells.solids.push(Solid::Hexahedron(nodes(node)?)),
            Shape::Wedge => self.cells.solids.push(Solid::Wedge(nodes(node)?)),
            Shape::Pyramid => self.cells.solids.push(Solid::Pyramid(nodes(node)?)),
        }
        self.groups.add(shape.dimension(), &corners, cell, begin)
    }
}

fn nodes<const N: usize>(mut node: impl FnMut() -> Result<u32, ParseError>) -> Result<[u32; N], ParseError> {
    let mut nodes = [0; N];
    for corner in &mut nodes {
        *corner = node()?;
    }
    Ok(nodes)
}
