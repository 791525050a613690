//! Half spaces that no vertex may enter.

use std::ops::Range;

use exact_ccd::Separation;
use exact_ccd_mesh::{Frame, HalfSpace, Motion, Point};
use rayon::prelude::*;
use serde::Serialize;

use crate::contacts::{Bounds, ContactRecord, RecordKind, unsigned_zero};
use crate::text::numbers::numbers;

/// The option `--half-space`.
#[derive(clap::Args, Debug)]
pub(crate) struct HalfSpaceOption {
    /// A half space that no vertex of a part that moves may touch, nor come within the minimum distance
    /// of; may be repeated: a point of its boundary, then its outward normal, of any length.
    #[arg(long, value_name = "X,Y,Z,NX,NY,NZ", value_parser = parse, allow_hyphen_values = true, conflicts_with = "certificate")]
    half_space: Vec<HalfSpace>,
}

/// A half space on the command line: a point of its boundary, then the normal, which points outward.
fn parse(text: &str) -> Result<HalfSpace, String> {
    let Some([x, y, z, nx, ny, nz]) = numbers(text) else {
        return Err("expected six numbers: a point of the boundary, then the outward normal".to_owned());
    };
    let half_space = HalfSpace::new([x, y, z], [nx, ny, nz]);
    half_space.check().map_err(|error| error.to_string())?;
    Ok(half_space)
}

/// Half spaces, and the vertices that must stay apart from them.
pub(crate) struct HalfSpaces {
    half_spaces: Vec<HalfSpace>,
    /// The distance that vertices must exceed.
    min_distance: Separation,
    /// The minimum distance for vertices that start within `min_distance`.
    inner_distance: Separation,
    vertices: Vec<Range<u32>>,
}

/// The numbers of vertices that touch a half space, counted for each half space, as a part of a JSON object.
#[derive(Clone, Copy, Serialize)]
pub(crate) struct HalfSpaceCounts {
    pub(crate) touching_at_start: usize,
    pub(crate) colliding: usize,
}

impl HalfSpaceOption {
    /// Returns true if there are half spaces.
    pub(crate) fn is_given(&self) -> bool {
        !self.half_space.is_empty()
    }

    /// The half spaces for these vertices, and the distances that they must exceed.
    pub(crate) fn around(
        &self,
        vertices: Vec<Range<u32>>,
        min_distance: Separation,
        inner_distance: Option<Separation>,
    ) -> HalfSpaces {
        HalfSpaces {
            half_spaces: self.half_space.clone(),
            min_distance,
            inner_distance: inner_distance.unwrap_or(min_distance),
            vertices,
        }
    }
}

impl HalfSpaces {
    /// The half spaces, in the order of their numbers.
    pub(crate) fn all(&self) -> &[HalfSpace] {
        &self.half_spaces
    }

    /// The vertices of a frame that are not apart from a half space, decided exactly, in the order of the
    /// half spaces.
    ///
    /// The signed distance of a vertex in linear motion is linear in time: the vertex is apart in a whole
    /// step if and only if it is apart at both ends. So the first contact is in the step before such a frame.
    pub(crate) fn touching(&self, index: usize, frame: &Frame) -> Vec<ContactRecord> {
        self.pairs(|pair| {
            let position = frame.positions[pair.vertex as usize];
            let is_apart = pair.half_space.is_apart(position, self.min_distance);
            (!is_apart).then(|| pair.contact(index, [position; 2], [0.0; 2], self.min_distance))
        })
    }

    /// The vertices that touch a half space in a step, with their first times, decided exactly, in the order
    /// of times, half spaces and vertices; and their numbers.
    pub(crate) fn in_step(&self, motion: &Motion) -> (Vec<ContactRecord>, HalfSpaceCounts) {
        let found = self.pairs(|pair| {
            let [start, end] = [&motion.x0, &motion.x1].map(|x| x[pair.vertex as usize]);
            let is_apart = |position, distance| pair.half_space.is_apart(position, distance);
            let starts_within = !is_apart(start, self.min_distance);
            let distance = if starts_within {
                self.inner_distance
            } else {
                self.min_distance
            };
            // The height is linear in time.
            let is_free = is_apart(start, distance) && is_apart(end, distance);
            (starts_within || !is_free).then(|| {
                let time = pair.half_space.first_contact([start, end], distance);
                let contact = time.map(|time| pair.contact(0, [start, end], time, distance));
                (starts_within, contact)
            })
        });
        let touching_at_start = found.iter().filter(|(starts_within, _)| *starts_within).count();
        let mut records: Vec<_> = found.into_iter().filter_map(|(_, contact)| contact).collect();
        records.sort_by(ContactRecord::compare_times);
        let colliding = records.len();
        let counts = HalfSpaceCounts {
            touching_at_start,
            colliding,
        };
        (records, counts)
    }

    /// The values of all pairs of a half space and a vertex that have one, in this order.
    fn pairs<T: Send>(&self, value: impl Fn(VertexHalfSpace<'_>) -> Option<T> + Sync) -> Vec<T> {
        let mut values = Vec::new();
        for (number, half_space) in (0..).zip(&self.half_spaces) {
            for vertices in self.vertices.iter().cloned() {
                let of_vertex = |vertex| {
                    value(VertexHalfSpace {
                        vertex,
                        number,
                        half_space,
                    })
                };
                values.par_extend(vertices.into_par_iter().filter_map(of_vertex));
            }
        }
        values
    }
}

/// A vertex and a half space with its number.
struct VertexHalfSpace<'a> {
    vertex: u32,
    number: u32,
    half_space: &'a HalfSpace,
}

impl VertexHalfSpace<'_> {
    /// The record of the contact, in a frame or in the step that begins at it, between two positions. It has
    /// its first time between two f64, within a distance.
    fn contact(
        &self,
        frame: usize,
        [start, end]: [Point; 2],
        [t, upper]: [f64; 2],
        distance: Separation,
    ) -> ContactRecord {
        let distance = distance.get();
        let point = [0, 1, 2].map(|axis| (1.0 - t) * start[axis] + t * end[axis]);
        ContactRecord {
            frame,
            kind: RecordKind::HalfSpace,
            ids: [Some(self.vertex), Some(self.number)],
            vertices: [vec![self.vertex], Vec::new()],
            mesh_vertices: [vec![self.vertex], Vec::new()],
            time: Bounds { lower: t, upper },
            point: Some(point.map(unsigned_zero)),
            normal: Some(self.half_space.unit_normal().map(unsigned_zero)),
            parameters: None,
            // A vertex that starts beyond the distance has it exactly at the first time.
            distance: Bounds {
                lower: if upper == 0.0 { 0.0 } else { distance },
                upper: distance,
            },
            owners: None,
        }
    }
}
