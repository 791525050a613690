//! Physical groups: their names, and the elements that belong to them.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

use super::super::budget::Budget;
use super::super::group::{Group, PhysicalTag};
use super::super::record::Record;
use super::super::tokens::Tokens;
use super::nodes::count_line;
use super::{DOUBLE, INT, Version};
use crate::error::{Fault, ParseError, Place};

/// The physical groups of a file, under construction.
pub(super) struct Groups<'b> {
    groups: BTreeMap<PhysicalTag, Group>,
    /// Tags of groups, for each entity of the geometry one after the other; 0 stands for none.
    tags: Vec<u32>,
    /// The tags of each entity, by its dimension and its own tag. Version 2 has no entities.
    entities: HashMap<(i64, i64), Range<usize>>,
    /// The tags of the elements that follow.
    current: Range<usize>,
    /// An entity may be in many groups, and each of its elements is in all of them.
    budget: &'b Budget,
}

impl<'b> Groups<'b> {
    /// No groups.
    pub(super) fn new(budget: &'b Budget) -> Self {
        Self {
            groups: BTreeMap::new(),
            tags: Vec::new(),
            entities: HashMap::new(),
            current: 0..0,
            budget,
        }
    }

    /// Reads the section `$PhysicalNames`, which is text even in a binary file.
    pub(super) fn read_names(&mut self, tokens: &mut Tokens) -> Result<(), ParseError> {
        const NAME: &str = "a dimension, a tag and a name in quotes";
        for _ in 0..count_line(tokens, "the number of physical names")? {
            tokens.expect_line(|| NAME.to_owned())?;
            let line = tokens.rest_of_line().trim_ascii();
            let text = String::from_utf8_lossy(line);
            let (physical, name) = parse_name(&text).ok_or_else(|| tokens.unexpected(NAME, line))?;
            self.group(physical).name = name.replace(char::is_control, "\u{fffd}");
        }
        tokens.expect_line_of("$EndPhysicalNames")
    }

    /// Reads the section `$Entities` of version 4.
    pub(super) fn read_entities(&mut self, version: Version, tokens: &mut Tokens) -> Result<(), ParseError> {
        tokens.begin(Record::one("the numbers of entities"))?;
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = tokens.size("the number of entities of a dimension")?;
        }
        tokens.end()?;
        for (dimension, count) in (0..).zip(counts) {
            for number in 0..count {
                tokens.begin(Record::of("entity", number, count))?;
                self.read_entity(version, dimension, tokens)?;
                tokens.end()?;
            }
        }
        tokens.expect_line_of("$EndEntities")
    }

    fn read_entity(
        &mut self,
        version: Version,
        dimension: i64,
        tokens: &mut Tokens,
    ) -> Result<(), ParseError> {
        let entity = tokens.integer(INT, "the tag of an entity")?;
        let place = tokens.place();
        // A bounding box; in version 4.1, a point has a position.
        let coordinates = if dimension == 0 && version == Version::V41 {
            3
        } else {
            6
        };
        for _ in 0..coordinates {
            tokens.real(DOUBLE, "a coordinate of an entity")?;
        }
        let first = self.tags.len();
        for _ in 0..tokens.size("the number of physical tags")? {
            let tag = tokens.integer(INT, "the tag of a physical group")?;
            self.tags.push(absolute(tag, tokens.place())?);
        }
        if dimension > 0 {
            for _ in 0..tokens.size("the number of bounding entities")? {
                tokens.integer(INT, "the tag of a bounding entity")?;
            }
        }
        let tags = first..self.tags.len();
        match self.entities.insert((dimension, entity), tags) {
            None => {
                self.budget.hold::<((i64, i64), Range<usize>)>(1);
                Ok(())
            }
            Some(_) => {
                let expected = format!("an entity of dimension {dimension} with a tag of its own");
                Err(Fault::expected(expected, format!("`{entity}`")).at(place))
            }
        }
    }

    /// The elements that follow belong to an entity of version 4.
    pub(super) fn set_entity(&mut self, dimension: i64, entity: i64) {
        let tags = self.entities.get(&(dimension, entity)).cloned();
        self.current = tags.unwrap_or_default();
    }

    /// The next element of version 2 has this tag of a group, or none.
    pub(super) fn set_tag(&mut self, tag: Option<(i64, Place)>) -> Result<(), ParseError> {
        self.tags.clear();
        if let Some((tag, place)) = tag {
            self.tags.push(absolute(tag, place)?);
        }
        self.current = 0..self.tags.len();
        Ok(())
    }

    /// Adds an element with these vertices, and with its place if it is a cell with volume.
    pub(super) fn add(
        &mut self,
        dimension: u8,
        vertices: &[u32],
        cell: Option<u32>,
        place: Place,
    ) -> Result<(), ParseError> {
        for index in self.current.clone() {
            let tag = self.tags[index];
            if tag > 0 {
                let numbers = vertices.len() + usize::from(cell.is_some());
                let bytes = size_of::<u32>() * numbers;
                self.budget.take(bytes as u64).map_err(|fault| fault.at(place))?;
                let group = self.group(PhysicalTag { dimension, tag });
                group.vertices.extend(vertices);
                group.cells.extend(cell);
            }
        }
        Ok(())
    }

    fn group(&mut self, physical: PhysicalTag) -> &mut Group {
        self.groups.entry(physical).or_insert_with(|| {
            self.budget.hold::<(PhysicalTag, Group)>(1);
            Group {
                physical: Some(physical),
                ..Group::default()
            }
        })
    }

    /// The groups that have elements, by increasing dimension and tag. The file has this number of vertices.
    pub(super) fn finish(self, vertex_count: usize) -> Vec<Group> {
        let mut groups: Vec<Group> = self.groups.into_values().collect();
        groups.retain(|group| !group.vertices.is_empty());
        // The last group that has each vertex, from 1.
        let mut last = vec![0; vertex_count];
        for (number, group) in (1_u64..).zip(&mut groups) {
            let is_new = |vertex: &u32| std::mem::replace(&mut last[*vertex as usize], number) != number;
            group.vertices.retain(is_new);
            group.vertices.sort_unstable();
            // A tag that an entity has twice.
            group.cells.dedup();
        }
        groups
    }
}

/// The tag of a group without its sign, which is the orientation of the elements.
fn absolute(tag: i64, place: Place) -> Result<u32, ParseError> {
    let expected = "the tag of a physical group, of four bytes";
    u32::try_from(tag.unsigned_abs()).map_err(|_| Fault::expected(expected, format!("`{tag}`")).at(place))
}

/// The tag and the name in a line such as `2 7 "left"`.
fn parse_name(line: &str) -> Option<(PhysicalTag, &str)> {
    let (dimension, rest) = line.trim().split_once(char::is_whitespace)?;
    let (tag, name) = rest.trim_start().split_once(char::is_whitespace)?;
    let name = name.trim().strip_prefix('"')?.strip_suffix('"')?;
    let dimension = dimension.parse().ok().filter(|dimension| *dimension <= 3)?;
    let tag = tag.parse().ok()?;
    Some((PhysicalTag { dimension, tag }, name))
}
