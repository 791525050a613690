//! The distance that the surfaces of a system keep, by the exact decision of each pair, one by one. Pairs are
//! found here, not by the broad phase.

use exact_ccd::{EdgeEdge, Kind, Query, Separation, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_mesh::{Aabb, Point};
use exact_ccd_sim::System;

/// The positions of a system before and after an increment, with the offset of each vertex.
pub(crate) struct Increment<'a> {
    pub(crate) system: &'a System,
    pub(crate) offsets: &'a [f64],
    pub(crate) before: &'a [Point],
    pub(crate) after: &'a [Point],
}

impl Increment<'_> {
    /// Asserts that no two primitives come within the sum of their offsets, except pairs of two obstacles and
    /// pairs that share a vertex.
    pub(crate) fn assert_thick(&self) {
        let mesh = self.system.surface();
        let corners = mesh.faces().as_flattened().iter();
        let mut vertices: Vec<u32> = corners.chain(mesh.edges().as_flattened()).copied().collect();
        vertices.extend(self.system.particles());
        vertices.sort_unstable();
        vertices.dedup();
        for &vertex in &vertices {
            for &[a, b, c] in mesh.faces() {
                self.assert_pair::<VertexFace>([vertex, a, b, c]);
            }
            for &[a, b] in mesh.edges() {
                self.assert_pair::<VertexEdge>([vertex, a, b]);
            }
            for &other in &vertices {
                self.assert_pair::<VertexVertex>([vertex, other]);
            }
        }
        for (index, &[a, b]) in mesh.edges().iter().enumerate() {
            for &[c, d] in &mesh.edges()[..index] {
                self.assert_pair::<EdgeEdge>([a, b, c, d]);
            }
        }
    }

    fn assert_pair<K: Kind>(&self, vertices: K::Vertices)
    where
        K::Points: Default,
    {
        let (first, second) = vertices.as_ref().split_at(K::FIRST);
        let is_fixed = |vertex: &u32| self.system.masses()[*vertex as usize] == 0.0;
        if first.iter().any(|vertex| second.contains(vertex)) || vertices.as_ref().iter().all(is_fixed) {
            return;
        }
        // Neighbours along a surface, whose common vertices are not among these primitives, are pairs as
        // well.
        let are_joined = |a: &u32, b: &u32| {
            let edge = [*a.min(b), *a.max(b)];
            self.system.surface().edges().contains(&edge)
        };
        let is_vertex_pair = K::FIRST == 1 && second.len() < 3;
        if is_vertex_pair && first.iter().any(|a| second.iter().any(|b| are_joined(a, b))) {
            return;
        }
        let offset = |vertices: &[u32]| {
            let offsets = vertices.iter().map(|&vertex| self.offsets[vertex as usize]);
            offsets.fold(0.0, f64::max)
        };
        let thickness = offset(first) + offset(second);
        let around = |vertices: &[u32]| -> Aabb {
            let positions = vertices.iter().flat_map(|&vertex| {
                let vertex = vertex as usize;
                [self.before[vertex], self.after[vertex]]
            });
            positions.collect()
        };
        let (a, b) = (around(first), around(second));
        let far = |axis: usize| {
            a.lower[axis] - b.upper[axis] > thickness || b.lower[axis] - a.upper[axis] > thickness
        };
        if (0..3).any(far) {
            return;
        }
        let at = |positions: &[Point]| {
            let mut points = K::Points::default();
            for (point, &vertex) in points.as_mut().iter_mut().zip(vertices.as_ref()) {
                *point = positions[vertex as usize];
            }
            points
        };
        let query = Query::<K>::new(at(self.before), at(self.after)).unwrap();
        let separation = Separation::new(thickness).unwrap();
        assert!(
            !query.collides(separation),
            "{vertices:?} come within {thickness}"
        );
    }
}
