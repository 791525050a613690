//! The section `$Nodes`.

use std::collections::HashMap;

use exact_ccd_mesh::Point;

use super::super::budget::Budget;
use super::values::{Record, Values, Version};
use crate::error::{Fault, ParseError, Place};

/// Positions in the order of the file, and their tags, which elements refer to.
#[derive(Default)]
pub(super) struct Nodes {
    pub(super) positions: Vec<Point>,
    pub(super) tags: Tags,
}

/// The index of each node, by its tag.
#[derive(Default)]
pub(super) struct Tags(HashMap<u64, u32>);

impl Tags {
    pub(super) fn count(&self) -> usize {
        self.0.len()
    }

    /// Counts the memory.
    pub(super) fn charge(&self, budget: &Budget) {
        budget.hold::<(u64, u32)>(self.0.len());
    }

    /// The node with this tag.
    pub(super) fn get(&self, tag: u64) -> Option<u32> {
        self.0.get(&tag).copied()
    }

    fn insert(&mut self, tag: u64, place: Place) -> Result<(), ParseError> {
        let index = u32::try_from(self.0.len()).map_err(|_| Fault::TooManyVertices.at(place))?;
        match self.0.insert(tag, index) {
            None => Ok(()),
            Some(_) => Err(Fault::expected("a node with a tag of its own", format!("`{tag}`")).at(place)),
        }
    }
}

pub(super) fn read<'a>(version: Version, values: &mut impl Values<'a>) -> Result<Nodes, ParseError> {
    let mut nodes = Nodes::default();
    match version {
        Version::V2 => read_v2(values, &mut nodes)?,
        Version::V4 => read_v4(values, &mut nodes)?,
    }
    values.end_section("$EndNodes")?;
    Ok(nodes)
}

/// Reads nodes one by one, each as tag and coordinates.
fn read_v2<'a>(values: &mut impl Values<'a>, nodes: &mut Nodes) -> Result<(), ParseError> {
    let count = values.count_line("the number of nodes")?;
    for number in 0..count {
        values.begin(Record::of("node", number, count))?;
        let place = values.place();
        let tag = values.int("the tag of a node")?;
        nodes.tags.insert(positive(tag, place)?, place)?;
        nodes.positions.push(read_position(values)?);
        values.end()?;
    }
    Ok(())
}

/// Reads nodes in blocks, one for each entity of the geometry: all tags, then all coordinates.
fn read_v4<'a>(values: &mut impl Values<'a>, nodes: &mut Nodes) -> Result<(), ParseError> {
    values.begin(Record::one("the numbers of blocks and nodes"))?;
    let blocks = values.size("the number of blocks")?;
    let count_place = values.place();
    let count = values.size("the number of nodes")?;
    values.size("the least tag of a node")?;
    values.size("the greatest tag of a node")?;
    values.end()?;
    for block in 0..blocks {
        values.begin(Record::of("node block", block, blocks))?;
        let place = values.place();
        let dimension = values.int("the dimension of an entity")?;
        values.int("the tag of an entity")?;
        let parametric = values.int("0 or 1 for parameters")? != 0;
        let nodes_in_block = values.size("the number of nodes in the block")?;
        values.end()?;
        let parameters = match dimension {
            0..=3 => i64::from(parametric) * dimension,
            _ => return Err(Fault::expected("a dimension from 0 to 3", format!("`{dimension}`")).at(place)),
        };
        for number in 0..nodes_in_block {
            values.begin(Record::of("the tag of node", number, nodes_in_block))?;
            let place = values.place();
            nodes.tags.insert(values.size("the tag of a node")?, place)?;
            values.end()?;
        }
        for number in 0..nodes_in_block {
            values.begin(Record::of("node", number, nodes_in_block))?;
            nodes.positions.push(read_position(values)?);
            for _ in 0..parameters {
                values.real("a parameter")?;
            }
            values.end()?;
        }
    }
    let found = nodes.positions.len();
    if found as u64 == count {
        return Ok(());
    }
    Err(Fault::expected(format!("{count} nodes"), found.to_string()).at(count_place))
}

fn read_position<'a>(values: &mut impl Values<'a>) -> Result<Point, ParseError> {
    let x = values.real("the coordinate x")?;
    let y = values.real("the coordinate y")?;
    let z = values.real("the coordinate z")?;
    Ok([x, y, z])
}

/// A tag from version 2, where it is a signed number.
pub(super) fn positive(tag: i64, place: Place) -> Result<u64, ParseError> {
    u64::try_from(tag).map_err(|_| Fault::expected("the tag of a node", format!("`{tag}`")).at(place))
}
