//! The kinds of query as kinds of pairs of a mesh.

use exact_ccd::{EdgeEdge, Kind, VertexEdge, VertexFace, VertexVertex};

use super::by_kind::ByKind;
use super::other_ends::OtherEnds;
use super::pair::Pair;
use crate::mesh::TriangleMesh;

/// A kind of query whose primitives have indices in a mesh.
pub trait PairKind: Kind + Send + Sync {
    /// True if [`are_connected`](Self::are_connected) holds for some primitives of this kind.
    const CAN_BE_CONNECTED: bool = false;

    /// The vertices of a pair, in the order of the query; `None` if the mesh has no such primitives.
    ///
    /// `ids` are the indices of the two primitives: of a vertex, of a face in
    /// [`TriangleMesh::faces`], of an edge in [`TriangleMesh::edges`].
    fn vertices(mesh: &TriangleMesh, ids: [u32; 2]) -> Option<Self::Vertices>;

    /// The pair with these indices.
    fn pair(ids: [u32; 2]) -> Pair;

    /// Returns true if the two primitives have no vertex in common.
    fn are_apart(vertices: &Self::Vertices) -> bool;

    /// Returns true if the primitives are a vertex and an edge, and another edge of the mesh connects them,
    /// as the last edge of a rod connects its end with the edge before. They touch at distance 0 only,
    /// whatever the minimum distance: see [`Pair`].
    fn are_connected(_mesh: &TriangleMesh, _vertices: &Self::Vertices) -> bool {
        false
    }
}

/// The sets of primitives of a mesh among which pairs are searched: of those that take part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PrimitiveSet {
    Vertices,
    Faces,
    Edges,
    /// The vertices of no edge. The corner of a face whose three corners are one vertex is among them.
    LooseVertices,
    /// The loose vertices, the ends of rods, and the corners of triangles of rods. A loose edge without such
    /// a vertex may share a vertex with each edge of the vertex.
    Ends,
    /// The edges of no face.
    LooseEdges,
}

impl PrimitiveSet {
    pub(crate) const COUNT: usize = 6;

    pub(crate) const ALL: [Self; Self::COUNT] = [
        Self::Vertices,
        Self::Faces,
        Self::Edges,
        Self::LooseVertices,
        Self::Ends,
        Self::LooseEdges,
    ];
}

/// A kind of pairs in the search for all pairs of a mesh.
pub(crate) trait Searched: PairKind {
    /// The sets of the first and of the second primitive. If they are the same, each pair is found
    /// once.
    const SETS: [PrimitiveSet; 2];

    /// Returns true if two edges are in contact where these primitives are. `None` if it is false for
    /// all pairs between the sets.
    const IS_COVERED: Option<fn(&OtherEnds, &Self::Vertices) -> bool> = None;

    /// The value of this kind.
    fn of<T>(values: &ByKind<T>) -> &T;
}

#[inline]
fn edge(mesh: &TriangleMesh, index: u32) -> Option<[u32; 2]> {
    mesh.edges().get(index as usize).copied()
}

#[inline]
fn has_vertex(mesh: &TriangleMesh, vertex: u32) -> bool {
    (vertex as usize) < mesh.vertex_count()
}

impl PairKind for VertexFace {
    #[inline]
    fn vertices(mesh: &TriangleMesh, [vertex, face]: [u32; 2]) -> Option<[u32; 4]> {
        let &[a, b, c] = mesh.faces().get(face as usize)?;
        has_vertex(mesh, vertex).then_some([vertex, a, b, c])
    }

    #[inline]
    fn are_apart([vertex, a, b, c]: &[u32; 4]) -> bool {
        (vertex != a) & (vertex != b) & (vertex != c)
    }

    fn pair([vertex, face]: [u32; 2]) -> Pair {
        Pair::VertexFace { vertex, face }
    }
}

impl Searched for VertexFace {
    const SETS: [PrimitiveSet; 2] = [PrimitiveSet::Vertices, PrimitiveSet::Faces];

    fn of<T>(values: &ByKind<T>) -> &T {
        &values.vertex_face
    }
}

impl PairKind for EdgeEdge {
    #[inline]
    fn vertices(mesh: &TriangleMesh, [a, b]: [u32; 2]) -> Option<[u32; 4]> {
        let ([a0, a1], [b0, b1]) = (edge(mesh, a)?, edge(mesh, b)?);
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

impl Searched for EdgeEdge {
    const SETS: [PrimitiveSet; 2] = [PrimitiveSet::Edges; 2];

    fn of<T>(values: &ByKind<T>) -> &T {
        &values.edge_edge
    }
}

impl PairKind for VertexEdge {
    const CAN_BE_CONNECTED: bool = true;

    #[inline]
    fn vertices(mesh: &TriangleMesh, [vertex, index]: [u32; 2]) -> Option<[u32; 3]> {
        let [a, b] = edge(mesh, index)?;
        has_vertex(mesh, vertex).then_some([vertex, a, b])
    }

    #[inline]
    fn are_apart([vertex, a, b]: &[u32; 3]) -> bool {
        (vertex != a) & (vertex != b)
    }

    fn pair([vertex, edge]: [u32; 2]) -> Pair {
        Pair::VertexEdge { vertex, edge }
    }

    fn are_connected(mesh: &TriangleMesh, &[vertex, a, b]: &[u32; 3]) -> bool {
        [a, b].iter().any(|&end| mesh.edge(vertex, end).is_some())
    }
}

impl Searched for VertexEdge {
    const SETS: [PrimitiveSet; 2] = [PrimitiveSet::Ends, PrimitiveSet::LooseEdges];

    const IS_COVERED: Option<fn(&OtherEnds, &[u32; 3]) -> bool> =
        Some(|ends, &[vertex, a, b]| ends.has_edge_apart_from(vertex, [a, b]));

    fn of<T>(values: &ByKind<T>) -> &T {
        &values.vertex_edge
    }
}

impl PairKind for VertexVertex {
    #[inline]
    fn vertices(mesh: &TriangleMesh, [a, b]: [u32; 2]) -> Option<[u32; 2]> {
        (has_vertex(mesh, a) && has_vertex(mesh, b)).then_some([a, b])
    }

    #[inline]
    fn are_apart([a, b]: &[u32; 2]) -> bool {
        a != b
    }

    fn pair([a, b]: [u32; 2]) -> Pair {
        Pair::VertexVertex {
            a: a.min(b),
            b: a.max(b),
        }
    }
}

impl Searched for VertexVertex {
    const SETS: [PrimitiveSet; 2] = [PrimitiveSet::LooseVertices; 2];

    fn of<T>(values: &ByKind<T>) -> &T {
        &values.vertex_vertex
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn primitives_without_a_common_vertex_are_apart() {
        fn assert_apart<K: PairKind>(vertices: K::Vertices) {
            let (a, b) = vertices.as_ref().split_at(K::FIRST);
            let expected = a.iter().all(|vertex| !b.contains(vertex));
            assert_eq!(K::are_apart(&vertices), expected, "{vertices:?}");
        }
        for i in 0..625 {
            let [a, b, c, d] = [i % 5, i / 5 % 5, i / 25 % 5, i / 125];
            assert_apart::<VertexFace>([a, b, c, d]);
            assert_apart::<EdgeEdge>([a, b, c, d]);
            assert_apart::<VertexEdge>([a, b, c]);
            assert_apart::<VertexVertex>([a, b]);
        }
    }
}
