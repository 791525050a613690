//! The primitives of a mesh, and the pairs of them for which contact counts.
//!
//! Two primitives are apart if they have no common vertex. A vertex is loose if it has no edge, an edge if
//! it belongs to no face. The pairs are: a vertex and a face, apart; two edges, apart; a vertex and a
//! loose edge, apart, if no edge of the vertex is apart from it; and two loose vertices. With a distance,
//! the third kind counts at distance 0 only, unless the vertex is loose.

use std::slice;

use dashu_int::IBig;

use crate::failure::{Failure, unreadable};
use crate::motion::Motion;

/// The connectivity of a mesh.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Mesh {
    /// The number of vertices.
    pub vertex_count: u32,
    /// The corners of each face.
    pub faces: Vec<[u32; 3]>,
    /// The edges of the faces, then the loose edges: each (i, j) with i < j once, sorted by j, then by i.
    pub edges: Vec<[u32; 2]>,
    /// The number of edges of faces.
    pub face_edges: usize,
    /// The number of edges of each vertex.
    degrees: Vec<u32>,
}

/// The kinds of pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A vertex and a face.
    VertexFace,
    /// Two edges, the lesser index first.
    EdgeEdge,
    /// A vertex and a loose edge.
    VertexEdge,
    /// Two loose vertices, the lesser index first.
    VertexVertex,
    /// An edge and a face, for the statement about t = 0.
    EdgeFace,
}

impl Kind {
    /// All kinds, in the order of their numbers in a certificate.
    pub const ALL: [Self; 5] =
        [Self::VertexFace, Self::EdgeEdge, Self::VertexEdge, Self::VertexVertex, Self::EdgeFace];

    /// The names of the two primitives.
    pub fn names(self) -> [&'static str; 2] {
        let [vertex, edge, face] = ["vertex", "edge", "face"];
        [[vertex, face], [edge, edge], [vertex, edge], [vertex, vertex], [edge, face]][self as usize]
    }
}

/// The vertices of the two primitives of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pair<'a> {
    /// The vertices of the first primitive.
    pub first: &'a [u32],
    /// The vertices of the second primitive.
    pub second: &'a [u32],
    /// True if nearness within the distance counts, and not contact alone.
    pub has_distance: bool,
}

impl Pair<'_> {
    /// The vertices of the first primitive, then the vertices of the second.
    pub fn vertices(&self) -> impl Iterator<Item = u32> {
        self.first.iter().chain(self.second).copied()
    }

    /// The distance that counts for this pair.
    pub fn distance(&self, motion: &Motion) -> IBig {
        if self.has_distance { motion.distance.clone() } else { IBig::ZERO }
    }
}

impl Mesh {
    /// The mesh of these faces and edges. An edge of a vertex with itself is left out.
    ///
    /// # Errors
    /// If an index is not below the number of vertices, or if there are 2³² vertices or more.
    pub fn new(vertex_count: usize, faces: Vec<[u32; 3]>, edges: &[[u32; 2]]) -> Result<Self, Failure> {
        let mut indices = faces.as_flattened().iter().chain(edges.as_flattened());
        let Ok(count) = u32::try_from(vertex_count) else {
            return unreadable("there are more than 2^32 - 1 vertices");
        };
        if indices.any(|&vertex| vertex >= count) {
            return unreadable("a face or an edge names a vertex that does not exist");
        }
        let mut all = sorted(faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]));
        let face_edges = all.len();
        let mut loose = sorted(edges.iter().copied());
        loose.retain(|&edge| all.binary_search_by_key(&order(edge), |&e| order(e)).is_err());
        all.append(&mut loose);
        let mut degrees = vec![0; vertex_count];
        for &vertex in all.as_flattened() {
            degrees[vertex as usize] += 1;
        }
        Ok(Self { vertex_count: count, faces, edges: all, face_edges, degrees })
    }

    fn has_edge(&self, a: u32, b: u32) -> bool {
        let (of_faces, loose) = self.edges.split_at(self.face_edges);
        let key = order([a.min(b), a.max(b)]);
        [of_faces, loose].iter().any(|edges| edges.binary_search_by_key(&key, |&e| order(e)).is_ok())
    }

    /// The pair of two primitives, if it exists and counts.
    pub fn pair<'a>(&'a self, kind: Kind, ids: &'a [u32; 2]) -> Option<Pair<'a>> {
        let ([a, b], [first, second]) = (*ids, ids.each_ref().map(slice::from_ref));
        let degree = |vertex: u32| self.degrees.get(vertex as usize).copied();
        let (edge, face) = (|id: u32| self.edges.get(id as usize), |id: u32| self.faces.get(id as usize));
        let (first, second): (&[u32], &[u32]) = match kind {
            Kind::VertexFace => (first, face(b)?),
            Kind::EdgeEdge => (edge(a)?, edge(b)?),
            Kind::VertexEdge => (first, edge(b).filter(|_| b as usize >= self.face_edges)?),
            Kind::VertexVertex => (first, second),
            Kind::EdgeFace => (edge(a)?, face(b)?),
        };
        let are_apart = first.iter().all(|vertex| !second.contains(vertex) && *vertex < self.vertex_count);
        let is_ordered = a < b || !matches!(kind, Kind::EdgeEdge | Kind::VertexVertex);
        let counts = are_apart
            && is_ordered
            && match *second {
                [b] => degree(a) == Some(0) && degree(b) == Some(0),
                [b, c] if kind == Kind::VertexEdge => {
                    degree(a)? == [b, c].into_iter().map(|end| u32::from(self.has_edge(a, end))).sum()
                }
                _ => true,
            };
        let has_distance = match kind {
            Kind::VertexEdge => degree(a) == Some(0),
            Kind::EdgeFace => false,
            _ => true,
        };
        counts.then_some(Pair { first, second, has_distance })
    }

    /// The first or the second primitives of all pairs of a kind: their indices, and three vertices each. If
    /// a primitive has fewer, its last vertex is repeated.
    pub fn primitives(&self, kind: Kind, is_second: bool) -> Vec<(u32, [u32; 3])> {
        let vertices = |most: u32| {
            let all = (0..self.vertex_count).zip(&self.degrees);
            all.filter(|(_, degree)| **degree <= most).map(|(vertex, _)| (vertex, [vertex; 3])).collect()
        };
        let edges =
            |from: usize| (0..).zip(&self.edges).skip(from).map(|(id, &[a, b])| (id, [a, b, b])).collect();
        match (kind, is_second) {
            (Kind::VertexFace, false) => vertices(u32::MAX),
            (Kind::VertexFace | Kind::EdgeFace, true) => (0..).zip(self.faces.iter().copied()).collect(),
            (Kind::EdgeEdge, _) | (Kind::EdgeFace, false) => edges(0),
            // All edges of such a vertex lead to the two ends of an edge.
            (Kind::VertexEdge, false) => vertices(2),
            (Kind::VertexEdge, true) => edges(self.face_edges),
            (Kind::VertexVertex, _) => vertices(0),
        }
    }
}

fn sorted(edges: impl Iterator<Item = [u32; 2]>) -> Vec<[u32; 2]> {
    let proper = edges.filter(|[a, b]| a != b);
    let mut edges: Vec<_> = proper.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    edges.sort_unstable_by_key(|&edge| order(edge));
    edges.dedup();
    edges
}

fn order([i, j]: [u32; 2]) -> (u32, u32) {
    (j, i)
}
