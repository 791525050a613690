//! The two kinds of pairs of primitives.

use exact_ccd::{EdgeEdge, Kind, VertexFace};

use crate::mesh::TriangleMesh;
use crate::pair::Pair;

/// A kind of query, as a mesh sees it.
pub(crate) trait PairKind: Kind {
    /// The vertices of a pair in the order of the query; `None` if the mesh has no such primitives.
    fn vertices(mesh: &TriangleMesh, ids: [u32; 2]) -> Option<[u32; 4]>;

    /// Whether the primitives have no vertex in common.
    fn are_apart(vertices: &[u32; 4]) -> bool;

    /// The pair with these indices.
    fn pair(ids: [u32; 2]) -> Pair;
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
