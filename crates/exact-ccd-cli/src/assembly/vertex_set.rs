//! The vertices of a part or of a group, by its name.

use std::ops::Range;

use super::part::Part;
use crate::messages::failure::{Failure, listed};

/// Vertices of the scene.
pub(super) struct VertexSet {
    first: u32,
    /// A flag for each vertex from the first one on.
    flags: Vec<bool>,
}

impl VertexSet {
    pub(super) fn has_all(&self, vertices: &[u32]) -> bool {
        vertices.iter().all(|&vertex| self.has(vertex))
    }

    pub(super) fn has_any(&self, vertices: &[u32]) -> bool {
        vertices.iter().any(|&vertex| self.has(vertex))
    }

    /// The vertices.
    #[cfg(feature = "repair")]
    pub(super) fn vertices(&self) -> impl Iterator<Item = u32> {
        let end = self.first + self.flags.len() as u32;
        (self.first..end).filter(|&vertex| self.has(vertex))
    }

    /// Returns true if they are of the part with these vertices.
    pub(super) fn is_of(&self, part: &Range<u32>) -> bool {
        part.contains(&self.first)
    }

    fn has(&self, vertex: u32) -> bool {
        let index = vertex.checked_sub(self.first);
        index.is_some_and(|index| self.flags.get(index as usize) == Some(&true))
    }
}

/// The vertices of the part with a name; else of the group `PART/GROUP`; else of the only group with this
/// name.
pub(super) fn named_set(parts: &[Part], name: &str) -> Result<VertexSet, Failure> {
    if let Some(part) = parts.iter().find(|part| part.name == name) {
        return Ok(VertexSet {
            first: part.vertices.start,
            flags: vec![true; part.vertices.len()],
        });
    }
    let groups = || {
        parts
            .iter()
            .flat_map(|part| part.groups.iter().map(move |group| (part, group)))
    };
    let long_name = |part: &Part, group: &str| format!("{}/{group}", part.name);
    let mut found = groups().filter(|(part, group)| long_name(part, &group.name) == name);
    let mut named = groups().filter(|(_, group)| group.name == name);
    let (part, group) = match (found.next(), named.next(), named.next()) {
        (Some(found), _, _) | (None, Some(found), None) => found,
        (None, Some((first, _)), Some((second, _))) => {
            return Err(Failure::new(format_args!(
                "several parts have a group {name}: its names are {}, {} and so on",
                long_name(first, name),
                long_name(second, name)
            )));
        }
        (None, None, _) => {
            let names = groups().map(|(_, group)| group.name.clone());
            let known = parts.iter().map(|part| part.name.clone()).chain(names);
            return Err(Failure::new(format_args!(
                "there is no part or group {name}; there are {}",
                listed(known, 20)
            )));
        }
    };
    let mut flags = vec![false; part.vertices.len()];
    for &vertex in &group.vertices {
        if let Some(flag) = flags.get_mut(vertex as usize) {
            *flag = true;
        }
    }
    let first = part.vertices.start;
    Ok(VertexSet { first, flags })
}
