//! Pairs of primitives of a mesh.

/// Two primitives of a mesh.
///
/// Pairs are ordered: vertices against faces before edges against edges, then by the first index, then by the second.
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
}

/// Numbers of pairs, by their kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PairCounts {
    /// How many pairs of a vertex and a face.
    pub vertex_face: usize,
    /// How many pairs of two edges.
    pub edge_edge: usize,
}

impl PairCounts {
    /// How many pairs of either kind.
    #[must_use]
    pub fn total(&self) -> usize {
        self.vertex_face + self.edge_edge
    }
}
