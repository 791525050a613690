//! Pairs of primitives of a mesh.

use crate::by_kind::PairCounts;

/// Two primitives of a mesh without a common vertex.
///
/// Pairs are ordered by their kind, as below, then by the first index, then by the second.
///
/// Only primitives [that take part](crate::CanCollide::among) form pairs. Among these, an edge is *loose*
/// if it belongs to no face, and a vertex if it has no edge.
///
/// # All distances
///
/// These four kinds of pairs cover the distance of any two primitives without a common vertex, except
/// near the ends of rods as stated below.
///
/// The least distance of an edge or a face and another edge or face is that of a vertex and a face or of
/// two edges among them, or 0 where an edge passes through a face. Before an edge passes through a face,
/// a vertex and the face or two edges come into contact, unless the two intersect at the start, which
/// [`intersections`](crate::intersections) finds.
///
/// The remaining cases are a vertex p against an edge e, and against a vertex q. Primitives contain their
/// edges and vertices. So a pair of which one contains p, and the other e or q, is at most as far apart.
/// There is one, if
///
/// - e or q belongs to a face without p, or p to a face without q: the vertex and that face;
/// - p is an end of an edge that has no vertex in common with e, or with an edge of q: both edges;
/// - p belongs to no edge, and e or q to no face: the loose vertex p and the loose edge e, or an edge
///   of q, or the loose vertex q.
///
/// There is none in two cases, and the two are not compared then, whatever the distance:
///
/// - p against e, if p has edges, all of them share a vertex with e, and all faces of e contain p: the
///   end of a rod against the edge before the last, with which its only edge shares a vertex; the
///   corner of a face, or of a triangle of rods, against the opposite edge;
/// - p against q, if both have edges, each edge of p shares a vertex with each of q, and all faces of
///   either contain both: the two ends of an edge, or of a rod of two edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Pair {
    /// A vertex against a face.
    VertexFace {
        /// The index of the vertex.
        vertex: u32,
        /// The index of the face in [`TriangleMesh::faces`](crate::TriangleMesh::faces).
        face: u32,
    },
    /// Two edges, a < b.
    EdgeEdge {
        /// The index of the first edge in [`TriangleMesh::edges`](crate::TriangleMesh::edges).
        a: u32,
        /// The index of the second edge.
        b: u32,
    },
    /// A loose vertex against a loose edge.
    VertexEdge {
        /// The index of the vertex.
        vertex: u32,
        /// The index of the edge in [`TriangleMesh::edges`](crate::TriangleMesh::edges).
        edge: u32,
    },
    /// Two loose vertices, a < b.
    VertexVertex {
        /// The index of the first vertex.
        a: u32,
        /// The index of the second vertex.
        b: u32,
    },
}

impl Pair {
    /// The indices of both primitives in the mesh.
    #[must_use]
    pub fn ids(&self) -> [u32; 2] {
        match *self {
            Self::VertexFace { vertex, face } => [vertex, face],
            Self::VertexEdge { vertex, edge } => [vertex, edge],
            Self::EdgeEdge { a, b } | Self::VertexVertex { a, b } => [a, b],
        }
    }
}

impl PairCounts {
    /// The numbers of pairs of each kind.
    pub(crate) fn of(pairs: &[Pair]) -> Self {
        let mut counts = Self::default();
        for pair in pairs {
            *match pair {
                Pair::VertexFace { .. } => &mut counts.vertex_face,
                Pair::EdgeEdge { .. } => &mut counts.edge_edge,
                Pair::VertexEdge { .. } => &mut counts.vertex_edge,
                Pair::VertexVertex { .. } => &mut counts.vertex_vertex,
            } += 1;
        }
        counts
    }
}
