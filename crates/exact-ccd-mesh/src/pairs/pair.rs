//! Pairs of primitives of a mesh.

use exact_ccd::{AnyKind, with_kind};

use super::kind::PairKind;
use crate::mesh::TriangleMesh;

/// Two primitives of a mesh without a common vertex.
///
/// Pairs are ordered by their kind, as below, then by the first index, then by the second. The page
/// `docs/pairs.md` of the repository lists all that is no pair, and so never in contact.
///
/// Only primitives [that take part](crate::CanCollide::among) form pairs. Among these, an edge is *loose*
/// if it belongs to no face, and a vertex if it has no edge. Two primitives are *apart* if they have no
/// common vertex. A vertex and an edge that are apart are *connected* if another edge leads from the vertex
/// to an end of the edge.
///
/// # All contacts
///
/// These four kinds of pairs cover the contact of any two primitives that are apart, except as stated below.
///
/// An edge or a face and another edge or face are nearest at a vertex and a face or at two edges of them, or
/// at distance 0 where an edge passes through a face. Before an edge passes through a face, a vertex and the
/// face or two edges come into contact, unless the edge and the face intersect at the start, which
/// [`intersections`](crate::intersections) finds.
///
/// The remaining cases are a vertex p against an edge e, and against a vertex q. Primitives contain their
/// edges and vertices. So a pair is at most as far apart if one primitive contains p, and the other e or q.
/// There is such a pair, if
///
/// - e or q belongs to a face without p, or p to a face without q: the vertex and that face;
/// - p is an end of an edge that is apart from e, or from an edge of q: both edges;
/// - p belongs to no edge, and e or q to no face: the loose vertex p and the loose edge e, or an edge
///   of q, or the loose vertex q;
/// - p has edges, none of them is apart from e, and e is loose: p and e. An edge of p leads to an end of e,
///   so they are connected: the end of a rod and the edge before the last, or the corner of a triangle of
///   rods and the opposite edge;
/// - q belongs to a loose edge e without p: p and e, as above, or an edge of p and e. The same with p and q
///   exchanged.
///
/// There is none in two cases, and the two are not compared then:
///
/// - p against e, if p has edges, none of them is apart from e, e belongs to a face, and all faces of e
///   contain p: the corner of a face against the opposite side;
/// - p against q, if both have edges, no edge of p is apart from one of q, and all faces and loose edges of
///   either contain both: the two ends of an edge.
///
/// # All distances
///
/// Within a distance d above 0, the same holds, except for the pairs that are connected. They touch at
/// distance 0 only, whatever d. In a triangle of rods, or where rods meet at a small angle, p is nearer to e
/// at rest than any of the edges is long: with such a d, the mesh would touch itself in every motion. The
/// price is that the end of a rod may fold to within d of the edge before the last; it touches that edge only
/// at distance 0, so that the rod does not pass through itself. So there are two more cases for distances,
/// and both are compared for contact:
///
/// - p against e, if p has edges, none of them is apart from e, and e is loose;
/// - p against q, if both have edges, no edge of p is apart from one of q, and all faces of either contain
///   both: the two ends of a rod of two edges.
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
    /// A vertex against a loose edge, from which no edge of the vertex is apart.
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
    /// The pair of a kind with these indices: of two edges or two vertices in either order.
    #[must_use]
    pub fn new(kind: AnyKind, [first, second]: [u32; 2]) -> Self {
        let [a, b] = [first.min(second), first.max(second)];
        match kind {
            AnyKind::VertexFace => Self::VertexFace {
                vertex: first,
                face: second,
            },
            AnyKind::EdgeEdge => Self::EdgeEdge { a, b },
            AnyKind::VertexEdge => Self::VertexEdge {
                vertex: first,
                edge: second,
            },
            AnyKind::VertexVertex => Self::VertexVertex { a, b },
        }
    }

    /// The kind of the pair.
    #[must_use]
    pub fn kind(&self) -> AnyKind {
        match self {
            Self::VertexFace { .. } => AnyKind::VertexFace,
            Self::EdgeEdge { .. } => AnyKind::EdgeEdge,
            Self::VertexEdge { .. } => AnyKind::VertexEdge,
            Self::VertexVertex { .. } => AnyKind::VertexVertex,
        }
    }

    /// The indices of both primitives in the mesh.
    #[must_use]
    pub fn ids(&self) -> [u32; 2] {
        match *self {
            Self::VertexFace { vertex, face } => [vertex, face],
            Self::VertexEdge { vertex, edge } => [vertex, edge],
            Self::EdgeEdge { a, b } | Self::VertexVertex { a, b } => [a, b],
        }
    }

    /// The vertices of the pair, in the order of the query: the vertices of the first primitive, then those
    /// of the second, as many as the [sizes](AnyKind::sizes) of its kind. `None` if the mesh has no such
    /// primitives.
    ///
    /// ```
    /// use exact_ccd_mesh::{Pair, TriangleMesh};
    ///
    /// let mesh = TriangleMesh::new(4, vec![[2, 0, 1]])?;
    /// assert_eq!(Pair::VertexFace { vertex: 3, face: 0 }.vertices(&mesh), Some(vec![3, 2, 0, 1]));
    /// assert_eq!(Pair::VertexFace { vertex: 3, face: 1 }.vertices(&mesh), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn vertices(&self, mesh: &TriangleMesh) -> Option<Vec<u32>> {
        with_kind!(self.kind(), K => {
            K::vertices(mesh, self.ids()).map(|vertices| vertices.to_vec())
        })
    }
}
