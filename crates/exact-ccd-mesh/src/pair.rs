//! Pairs of primitives of a mesh, and their vertices.

use exact_ccd::{EdgeEdge, Kind, Point, VertexFace};

use crate::mesh::TriangleMesh;

/// Two primitives of a mesh.
///
/// Pairs are ordered: vertices against faces before edges against edges, then by the first index,
/// then by the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Pair {
    /// A vertex against a face.
    VertexFace {
        /// The index of the vertex.
        vertex: u32,
        /// The index of the face in [`TriangleMesh::faces`].
        face: u32,
    },
    /// Two edges, a < b.
    EdgeEdge {
        /// The index of the first edge in [`TriangleMesh::edges`].
        a: u32,
        /// The index of the second edge.
        b: u32,
    },
}

impl Pair {
    /// The four vertices of the pair, in the order of the query; `None` if the mesh has no such
    /// primitives.
    ///
    /// ```
    /// use exact_ccd_mesh::{Pair, TriangleMesh};
    ///
    /// let mesh = TriangleMesh::new(4, vec![[2, 0, 1]])?;
    /// assert_eq!(Pair::VertexFace { vertex: 3, face: 0 }.vertices(&mesh), Some([3, 2, 0, 1]));
    /// assert_eq!(Pair::VertexFace { vertex: 3, face: 1 }.vertices(&mesh), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn vertices(&self, mesh: &TriangleMesh) -> Option<[u32; 4]> {
        match *self {
            Self::VertexFace { vertex, face } => VertexFace::vertices(mesh, [vertex, face]),
            Self::EdgeEdge { a, b } => EdgeEdge::vertices(mesh, [a, b]),
        }
    }
}

/// Numbers of pairs, by their kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PairCounts {
    /// The number of pairs of a vertex and a face.
    pub vertex_face: usize,
    /// The number of pairs of two edges.
    pub edge_edge: usize,
}

impl PairCounts {
    /// The number of pairs of both kinds.
    #[must_use]
    pub fn total(&self) -> usize {
        self.vertex_face + self.edge_edge
    }
}

/// A kind of query whose primitives have indices in a mesh.
pub trait PairKind: Kind<Points = [Point; 4], Vertices = [u32; 4]> + Send + Sync {
    /// The four vertices of a pair, in the order of the query; `None` if the mesh has no such
    /// primitives.
    ///
    /// `ids` are the indices of the vertex and the face, or of the two edges.
    fn vertices(mesh: &TriangleMesh, ids: [u32; 2]) -> Option<[u32; 4]>;

    /// The pair with these indices.
    fn pair(ids: [u32; 2]) -> Pair;

    /// Returns true if the two primitives have no vertex in common.
    fn are_apart(vertices: &[u32; 4]) -> bool;
}

impl PairKind for VertexFace {
    #[inline]
    fn vertices(mesh: &TriangleMesh, [vertex, face]: [u32; 2]) -> Option<[u32; 4]> {
        let &[a, b, c] = mesh.faces().get(face as usize)?;
        ((vertex as usize) < mesh.vertex_count()).then_some([vertex, a, b, c])
    }

    #[inline]
    fn are_apart([vertex, a, b, c]: &[u32; 4]) -> bool {
        (vertex != a) & (vertex != b) & (vertex != c)
    }

    fn pair([vertex, face]: [u32; 2]) -> Pair {
        Pair::VertexFace { vertex, face }
    }
}

impl PairKind for EdgeEdge {
    #[inline]
    fn vertices(mesh: &TriangleMesh, [a, b]: [u32; 2]) -> Option<[u32; 4]> {
        let edge = |index: u32| mesh.edges().get(index as usize).copied();
        let ([a0, a1], [b0, b1]) = (edge(a)?, edge(b)?);
        Some([a0, a1, b0, b1])
    }

    #[inline]
    fn are_apart([a0, a1, b0, b1]: &[u32; 4]) -> bool {
        (a0 != b0) & (a0 != b1) & (a1 != b0) & (a1 != b1)
    }

    fn pair([a, b]: [u32; 2]) -> Pair {
        Pair::EdgeEdge {
            a: a.min(b),
            b: a.max(b),
        }
    }
}
