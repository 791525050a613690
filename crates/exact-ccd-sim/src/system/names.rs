//! The bodies and half spaces of a system by their places, and their names.

use std::collections::BTreeSet;
use std::ops::Range;

use super::bodies::ranges;
use super::{Designation, System};
use crate::body::Body;
use crate::energies::contact::Collision;
use crate::energies::term::Energy;

impl System {
    /// The range of vertices of each body, in the order of the bodies. The last four of an affine body are
    /// its nodes.
    #[must_use]
    pub fn ranges(bodies: &[Body]) -> Vec<Range<u32>> {
        ranges(bodies)
    }

    /// The body or half space with this place in [`System::names`], in messages.
    pub(crate) fn designation(&self, place: usize) -> Designation {
        match place.checked_sub(self.bodies.ranges.len()) {
            None => self.bodies.designation(place),
            Some(place) => self.geometry.half_space_designation(place),
        }
    }

    /// The name of each body, or `body-N` for the Nth body if it has none.
    #[must_use]
    pub fn body_names(&self) -> Vec<String> {
        let numbered = self.bodies.names.iter().enumerate();
        let name = |(number, name): (usize, &String)| match name.as_str() {
            "" => format!("body-{number}"),
            name => name.to_owned(),
        };
        numbered.map(name).collect()
    }

    /// The kind of each body: see [`BodyKind::name`](crate::BodyKind::name).
    #[must_use]
    pub fn body_kinds(&self) -> &[&'static str] {
        &self.bodies.kinds
    }

    /// The vertices of each body.
    #[must_use]
    pub fn body_vertices(&self) -> &[Range<u32>] {
        &self.bodies.ranges
    }

    /// The body of a vertex, by its place in the list of bodies.
    #[must_use]
    pub fn body_of(&self, vertex: u32) -> usize {
        self.bodies.of(vertex)
    }

    /// The bodies of a collision, by their places in the list of all bodies, followed by the half spaces.
    pub(crate) fn bodies_of(&self, collision: &Collision) -> [usize; 2] {
        // The vertices of the first primitive are first. A half space has none.
        let vertices = collision.vertices();
        let second = match collision.half_space() {
            Some(half_space) => self.bodies.ranges.len() + half_space as usize,
            None => self.body_of(vertices[vertices.len() - 1]),
        };
        [self.body_of(vertices[0]), second]
    }

    /// The names of all bodies, then of the half spaces. Empty for no name.
    #[must_use]
    pub fn names(&self) -> Vec<&str> {
        let half_spaces = self.half_spaces().iter().map(|half_space| &half_space.name);
        self.bodies
            .names
            .iter()
            .chain(half_spaces)
            .map(String::as_str)
            .collect()
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
