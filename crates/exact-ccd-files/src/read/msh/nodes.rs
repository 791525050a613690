//! The section `$Nodes`.

use std::collections::HashMap;

use exact_ccd_mesh::Point;

use super::super::budget::Budget;
use super::super::record::Record;
use super::super::tokens::Tokens;
use super::{DOUBLE, INT, Version};
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

pub(super) fn read(version: Version, tokens: &mut Tokens) -> Result<Nodes, ParseError> {
    let mut nodes = Nodes::default();
    match version {
        Version::V1 | Version::V2 => read_list(tokens, &mut nodes)?,
        Version::V40 | Version::V41 => read_blocks(version, tokens, &mut nodes)?,
    }
    tokens.expect_line_of(if version == Version::V1 {
        "$ENDNOD"
    } else {
        "$EndNodes"
    })?;
    Ok(nodes)
}

/// Reads nodes one by one, each as tag and coordinates.
fn read_list(tokens: &mut Tokens, nodes: &mut Nodes) -> Result<(), ParseError> {
    let count = count_line(tokens, "the number of nodes")?;
    for number in 0..count {
        tokens.begin(Record::of("node", number, count))?;
        let tag = positive_tag(tokens)?;
        nodes.tags.insert(tag, tokens.place())?;
        nodes.positions.push(read_position(tokens)?);
        tokens.end()?;
    }
    Ok(())
}

/// Reads nodes in blocks, one for each entity of the geometry: in version 4.0, each as tag and coordinates;
/// in version 4.1, all tags, then all coordinates.
fn read_blocks(version: Version, tokens: &mut Tokens, nodes: &mut Nodes) -> Result<(), ParseError> {
    tokens.begin(Record::one("the numbers of blocks and nodes"))?;
    let blocks = tokens.size("the number of blocks")?;
    let count = tokens.size("the number of nodes")?;
    let count_place = tokens.place();
    if version == Version::V41 {
        tokens.size("the least tag of a node")?;
        tokens.size("the greatest tag of a node")?;
    }
    tokens.end()?;
    for block in 0..blocks {
        tokens.begin(Record::of("node block", block, blocks))?;
        let [dimension, _] = entity(version, tokens)?;
        let place = tokens.place();
        let parametric = tokens.integer(INT, "0 or 1 for parameters")? != 0;
        let nodes_in_block = tokens.size("the number of nodes in the block")?;
        tokens.end()?;
        let parameters = match dimension {
            0..=3 => i64::from(parametric) * dimension,
            _ => return Err(Fault::expected("a dimension from 0 to 3", format!("`{dimension}`")).at(place)),
        };
        if version == Version::V41 {
            for number in 0..nodes_in_block {
                tokens.begin(Record::of("the tag of node", number, nodes_in_block))?;
                let place = tokens.place();
                nodes.tags.insert(tokens.size("the tag of a node")?, place)?;
                tokens.end()?;
            }
        }
        for number in 0..nodes_in_block {
            tokens.begin(Record::of("node", number, nodes_in_block))?;
            if version == Version::V40 {
                let tag = positive_tag(tokens)?;
                nodes.tags.insert(tag, tokens.place())?;
            }
            nodes.positions.push(read_position(tokens)?);
            for _ in 0..parameters {
                tokens.real(DOUBLE, "a parameter")?;
            }
            tokens.end()?;
        }
    }
    let found = nodes.positions.len();
    if found as u64 == count {
        return Ok(());
    }
    Err(Fault::expected(format!("{count} nodes"), found.to_string()).at(count_place))
}

fn read_position(tokens: &mut Tokens) -> Result<Point, ParseError> {
    let x = tokens.real(DOUBLE, "the coordinate x")?;
    let y = tokens.real(DOUBLE, "the coordinate y")?;
    let z = tokens.real(DOUBLE, "the coordinate z")?;
    Ok([x, y, z])
}

/// The dimension and the tag of an entity at the beginning of a block: in version 4.0, the tag is first.
pub(super) fn entity(version: Version, tokens: &mut Tokens) -> Result<[i64; 2], ParseError> {
    const DIMENSION: &str = "the dimension of an entity";
    const TAG: &str = "the tag of an entity";
    if version == Version::V40 {
        let tag = tokens.integer(INT, TAG)?;
        return Ok([tokens.integer(INT, DIMENSION)?, tag]);
    }
    Ok([tokens.integer(INT, DIMENSION)?, tokens.integer(INT, TAG)?])
}

/// The tag of a node before version 4.1, where it is a signed number.
pub(super) fn positive_tag(tokens: &mut Tokens) -> Result<u64, ParseError> {
    const TAG: &str = "the tag of a node";
    let tag = tokens.integer(INT, TAG)?;
    u64::try_from(tag).map_err(|_| Fault::expected(TAG, format!("`{tag}`")).at(tokens.place()))
}

/// A count on a line of its own, which is text even in a binary file.
pub(super) fn count_line(tokens: &mut Tokens, expected: &'static str) -> Result<u64, ParseError> {
    tokens.expect_line(|| expected.to_owned())?;
    let count = tokens.count(expected)?;
    tokens.expect_line_end()?;
    Ok(count)
}
