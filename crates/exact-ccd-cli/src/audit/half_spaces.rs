//! Half spaces that no vertex may enter.

use std::ops::Range;
use std::str::FromStr;

use exact_ccd::separation::Separation;
use exact_ccd_mesh::Frame;
use exact_ccd_sim::HalfSpace;

use crate::contacts::ContactRecord;

/// A half space on the command line: a point of its boundary, then the normal, which points outward.
#[derive(Clone, Debug)]
pub(super) struct HalfSpaceArgument(pub(super) HalfSpace);

impl FromStr for HalfSpaceArgument {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let words = text.split([' ', ',']).filter(|word| !word.is_empty());
        let numbers: Result<Vec<f64>, _> = words.map(str::parse).collect();
        let Ok(&[x, y, z, nx, ny, nz]) = numbers.as_deref() else {
            return Err("expected six numbers: a point of the boundary, then the outward normal".to_owned());
        };
        let (point, normal) = ([x, y, z], [nx, ny, nz]);
        let half_space = HalfSpace::new(point, normal);
        match half_space.check(0) {
            Ok(()) => Ok(Self(half_space)),
            Err(error) => Err(format!(
                "the {} is {:?}, expected {}",
                error.what, error.value, error.expected
            )),
        }
    }
}

/// Half spaces, and the vertices that must stay apart from them.
pub(super) struct HalfSpaces<'a> {
    pub(super) half_spaces: &'a [HalfSpaceArgument],
    /// The distance that vertices must exceed.
    pub(super) min_distance: Separation,
    pub(super) vertices: Vec<Range<u32>>,
}

impl HalfSpaces<'_> {
    /// The vertices of a frame that are not apart from a half space, each after the number of the half space,
    /// decided exactly, in the order of the half spaces.
    ///
    /// The signed distance of a vertex in linear motion is linear in time: the vertex is apart in a whole
    /// step if and only if it is apart at both ends. So the first contact is in the step before such a frame.
    pub(super) fn touching(&self, frame: &Frame) -> Vec<(u32, u32)> {
        let d = self.min_distance.get();
        let mut found = Vec::new();
        for (number, HalfSpaceArgument(half_space)) in (0..).zip(self.half_spaces) {
            let vertices = self.vertices.iter().cloned().flatten();
            let touching = vertices.filter(|&vertex| {
                let position = frame.positions[vertex as usize];
                !half_space.is_apart(position, d)
            });
            found.extend(touching.map(|vertex| (number, vertex)));
        }
        found
    }

    /// The record of a vertex of the frame `index` that is not apart from the half space of this number.
    pub(super) fn record(&self, index: usize, frame: &Frame, number: u32, vertex: u32) -> ContactRecord {
        let HalfSpaceArgument(half_space) = &self.half_spaces[number as usize];
        let position = frame.positions[vertex as usize];
        let normal = half_space.plane().normal.into();
        let d = self.min_distance.get();
        ContactRecord::of_half_space(vertex, position, number, normal, d).in_frame(index)
    }
}
