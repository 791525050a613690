//! The parts of rods that resist twist.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

/// A chain of edges that resists twist: a part of an isotropic rod.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Chain {
    /// Its vertices, in their order: at least three.
    vertices: Vec<u32>,
    /// The length of each inner vertex at rest, in m: half of both edges.
    lengths: Vec<f64>,
    /// The torsional rigidity G J, in N m².
    rigidity: f64,
}

impl Chain {
    /// The chain of these vertices, with the positions of all vertices at rest and the torsional rigidity G J
    /// in N m².
    pub(crate) fn new(vertices: Vec<u32>, rest: &[Point], rigidity: f64) -> Self {
        let mut chain = Self {
            vertices,
            lengths: Vec::new(),
            rigidity,
        };
        let edges: Vec<f64> = chain.edges(rest).iter().map(Vector3::norm).collect();
        let lengths = edges.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
        chain.lengths = lengths.collect();
        chain
    }

    /// The first and the last edge, by their vertices in the order of the chain.
    pub(crate) fn ends(&self) -> [[u32; 2]; 2] {
        let count = self.vertices.len();
        let edge = |first: usize| [self.vertices[first], self.vertices[first + 1]];
        [edge(0), edge(count - 2)]
    }

    /// The parts of the chain between each held edge and the next one. An edge is held if both of its
    /// vertices are.
    pub(crate) fn between_held(&self, is_held: impl Fn(u32) -> bool) -> Vec<Self> {
        let edges = self.vertices.windows(2).enumerate();
        let held = edges.filter(|(_, edge)| edge.iter().all(|&vertex| is_held(vertex)));
        let held: Vec<usize> = held.map(|(place, _)| place).collect();
        let part = |ends: &[usize]| Self {
            vertices: self.vertices[ends[0]..ends[1] + 2].to_vec(),
            lengths: self.lengths[ends[0]..ends[1]].to_vec(),
            rigidity: self.rigidity,
        };
        held.windows(2).map(part).collect()
    }

    /// The vertices, in their order.
    pub(super) fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    /// The edges, as vectors.
    pub(super) fn edges(&self, points: &[Point]) -> Vec<Vector3<f64>> {
        let at = |vertex: u32| Vector3::from(points[vertex as usize]);
        let pairs = self.vertices.windows(2);
        pairs.map(|pair| at(pair[1]) - at(pair[0])).collect()
    }

    /// The inner vertices.
    pub(crate) fn inner(&self) -> &[u32] {
        &self.vertices[1..self.vertices.len() - 1]
    }

    /// The share of each inner vertex in the length, and so in a twist.
    pub(crate) fn shares(&self) -> impl Iterator<Item = f64> {
        let length = self.length();
        self.lengths.iter().map(move |own| own / length)
    }

    /// The length L at rest between the midpoints of the first and the last edge, in m.
    fn length(&self) -> f64 {
        self.lengths.iter().sum()
    }

    /// G J / L, in J.
    pub(super) fn stiffness(&self) -> f64 {
        self.rigidity / self.length()
    }
}
