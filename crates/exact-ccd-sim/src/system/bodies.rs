//! The bodies of a system by their places.

use std::ops::Range;

use exact_ccd_mesh::Point;

use super::ball::diameter;
use super::designation::Designation;
use crate::body::{Body, BodyKind};
use crate::digest::Hash;

/// The bodies of a system, without their meshes.
#[derive(Clone, Debug)]
pub(crate) struct Bodies {
    /// The name of each body. Empty for no name.
    pub(super) names: Vec<String>,
    pub(super) kinds: Vec<&'static str>,
    /// The vertices of each body.
    pub(crate) ranges: Vec<Range<u32>>,
    /// The hash of the materials and offsets, for the fingerprint.
    pub(super) materials: String,
}

/// The range of vertices of each body, in the order of the bodies.
pub(super) fn ranges(bodies: &[Body]) -> Vec<Range<u32>> {
    let mut end = 0;
    let range = |body: &Body| {
        let start = end;
        end += body.vertex_count() as u32;
        start..end
    };
    bodies.iter().map(range).collect()
}

impl Bodies {
    pub(super) fn new(bodies: &[Body]) -> Self {
        let materials: Vec<(&BodyKind, f64)> = bodies.iter().map(|body| (&body.kind, body.offset)).collect();
        Self {
            names: bodies.iter().map(|body| body.name.clone()).collect(),
            kinds: bodies.iter().map(|body| body.kind.name()).collect(),
            ranges: ranges(bodies),
            materials: Hash::of(&materials),
        }
    }

    /// The body of a vertex, by its place.
    pub(crate) fn of(&self, vertex: u32) -> usize {
        self.ranges.partition_point(|range| range.end <= vertex)
    }

    /// The body at a place, in messages.
    pub(crate) fn designation(&self, place: usize) -> Designation {
        Designation::of_body(place, self.names.get(place).map_or("", String::as_str))
    }

    /// The names of the bodies, and the ends of their ranges of vertices.
    pub(super) fn named_ranges(&self) -> Vec<(&str, u32)> {
        let names = self.names.iter().map(String::as_str);
        names.zip(self.ranges.iter().map(|range| range.end)).collect()
    }

    /// The sizes of the bodies at these positions, in m.
    pub(crate) fn sizes(&self, points: &[Point]) -> impl Iterator<Item = f64> {
        let points = |range: &Range<u32>| points[range.start as usize..range.end as usize].iter();
        self.ranges
            .iter()
            .map(move |range| diameter(points(range).copied()))
    }
}
