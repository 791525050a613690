//! Bodies and half spaces by their places and names.

use std::collections::BTreeSet;
use std::ops::Range;

use super::{Designation, System};
use crate::contact::Collision;
use crate::energy::Energy;

impl System {
    /// The body or half space with this place in [`System::names`], in messages.
    #[must_use]
    pub fn designation(&self, place: usize) -> Designation {
        Designation::at(place, &self.names, &self.half_spaces)
    }

    /// The name of each body, or `body-N` for the Nth body if it has none.
    #[must_use]
    pub fn body_names(&self) -> Vec<String> {
        let name = |(number, name): (usize, &String)| match name.as_str() {
            "" => format!("body-{number}"),
            name => name.to_owned(),
        };
        self.names.iter().enumerate().map(name).collect()
    }

    /// The kind of each body: see [`BodyKind::name`](crate::BodyKind::name).
    #[must_use]
    pub fn body_kinds(&self) -> &[&'static str] {
        &self.kinds
    }

    /// The vertices of each body.
    #[must_use]
    pub fn body_vertices(&self) -> &[Range<u32>] {
        &self.bodies
    }

    /// The body of a vertex, by its place in the list of bodies.
    #[must_use]
    pub fn body_of(&self, vertex: u32) -> usize {
        self.bodies.partition_point(|range| range.end <= vertex)
    }

    /// The bodies of a collision, by their places in the list of all bodies, followed by the half spaces.
    pub(crate) fn bodies_of(&self, collision: &Collision) -> [usize; 2] {
        // The vertices of the first primitive precede those of the second. A half space has none.
        let vertices = collision.vertices();
        let second = match collision.half_space() {
            Some(half_space) => self.bodies.len() + half_space as usize,
            None => self.body_of(vertices[vertices.len() - 1]),
        };
        [self.body_of(vertices[0]), second]
    }

    /// The names of all bodies, followed by those of the half spaces. Empty for no name.
    #[must_use]
    pub fn names(&self) -> Vec<&str> {
        let half_spaces = self.half_spaces.iter().map(|half_space| &half_space.name);
        self.names.iter().chain(half_spaces).map(String::as_str).collect()
    }

    /// All names, quoted, for messages.
    pub(crate) fn known_names(&self) -> String {
        let names = self.names();
        let given: BTreeSet<String> = names
            .iter()
            .filter(|name| !name.is_empty())
            .map(|name| format!("`{name}`"))
            .collect();
        given.into_iter().collect::<Vec<_>>().join(", ")
    }
}
