//! The vertices of a pair.

use exact_ccd::{EdgeEdge, Kind, VertexEdge, VertexFace, VertexVertex};

use super::kind::PairKind;
use super::pair::Pair;
use crate::mesh::TriangleMesh;

impl Pair {
    /// The vertices of the pair, in the order of the query: those of the first primitive, then those
    /// of the second. `None` if the mesh has no such primitives.
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
        fn of<K: PairKind>(mesh: &TriangleMesh, ids: [u32; 2]) -> Option<Vec<u32>> {
            K::vertices(mesh, ids).map(|vertices| vertices.as_ref().to_vec())
        }
        match *self {
            Self::VertexFace { vertex, face } => of::<VertexFace>(mesh, [vertex, face]),
            Self::EdgeEdge { a, b } => of::<EdgeEdge>(mesh, [a, b]),
            Self::VertexEdge { vertex, edge } => of::<VertexEdge>(mesh, [vertex, edge]),
            Self::VertexVertex { a, b } => of::<VertexVertex>(mesh, [a, b]),
        }
    }

    /// The number of vertices of the first primitive, which are the first ones of
    /// [`vertices`](Self::vertices).
    #[must_use]
    pub fn first_len(&self) -> usize {
        match self {
            Self::EdgeEdge { .. } => EdgeEdge::FIRST,
            Self::VertexFace { .. } => VertexFace::FIRST,
            Self::VertexEdge { .. } => VertexEdge::FIRST,
            Self::VertexVertex { .. } => VertexVertex::FIRST,
        }
    }
}
