//! The kinds of query as kinds of pairs of a mesh.

use exact_ccd::{EdgeEdge, Kind, VertexEdge, VertexFace, VertexVertex};

use super::other_ends::OtherEnds;
use crate::mesh::TriangleMesh;

/// A kind of query whose primitives have indices in a mesh: a primitive with one point is a vertex, with two
/// an edge, with three a face.
pub trait PairKind: Kind {
    /// True if [`are_connected`](Self::are_connected) holds for some primitives of this kind.
    const CAN_BE_CONNECTED: bool = matches!(Self::OF_FOUR, [0, 0, 1, 2]);

    /// The vertices of a pair, in the order of the query; `None` if the mesh has no such primitives.
    ///
    /// `ids` are the indices of the two primitives: of a vertex, of a face in
    /// [`TriangleMesh::faces`], of an edge in [`TriangleMesh::edges`].
    #[inline]
    fn vertices(mesh: &TriangleMesh, ids: [u32; 2]) -> Option<Self::Vertices> {
        let mut vertices = Self::Vertices::default();
        let (first, second) = vertices.as_mut().split_at_mut(Self::FIRST);
        copy_vertices(mesh, ids[0], first)?;
        copy_vertices(mesh, ids[1], second)?;
        Some(vertices)
    }

    /// Returns true if the two primitives have no vertex in common.
    #[inline]
    fn are_apart(vertices: &Self::Vertices) -> bool {
        let (first, second) = vertices.as_ref().split_at(Self::FIRST);
        // Without a branch, which may be hard to predict.
        let differs = |a: &u32| second.iter().fold(true, |differ, b| differ & (a != b));
        first.iter().fold(true, |apart, a| apart & differs(a))
    }

    /// Returns true if the primitives are a vertex and an edge, and another edge of the mesh connects them,
    /// as the last edge of a rod connects its end with the edge before. They touch at distance 0 only,
    /// whatever the minimum distance: see [`Pair`](crate::Pair).
    fn are_connected(mesh: &TriangleMesh, vertices: &Self::Vertices) -> bool {
        let (first, second) = vertices.as_ref().split_at(Self::FIRST);
        let is_edge = |a: u32| second.iter().any(|&b| mesh.edge(a, b).is_some());
        Self::CAN_BE_CONNECTED && first.iter().any(|&a| is_edge(a))
    }
}

impl<K: Kind> PairKind for K {}

/// Writes the vertices of a primitive; `None` if the mesh does not have it.
#[inline(always)]
fn copy_vertices(mesh: &TriangleMesh, id: u32, vertices: &mut [u32]) -> Option<()> {
    match vertices {
        [vertex] if (id as usize) < mesh.vertex_count() => *vertex = id,
        [_, _] => vertices.copy_from_slice(mesh.edges().get(id as usize)?),
        [_, _, _] => vertices.copy_from_slice(mesh.faces().get(id as usize)?),
        _ => return None,
    }
    Some(())
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
}

impl Searched for VertexFace {
    const SETS: [PrimitiveSet; 2] = [PrimitiveSet::Vertices, PrimitiveSet::Faces];
}

impl Searched for EdgeEdge {
    const SETS: [PrimitiveSet; 2] = [PrimitiveSet::Edges; 2];
}

impl Searched for VertexEdge {
    const SETS: [PrimitiveSet; 2] = [PrimitiveSet::Ends, PrimitiveSet::LooseEdges];

    const IS_COVERED: Option<fn(&OtherEnds, &[u32; 3]) -> bool> =
        Some(|ends, &[vertex, a, b]| ends.has_edge_apart_from(vertex, [a, b]));
}

impl Searched for VertexVertex {
    const SETS: [PrimitiveSet; 2] = [PrimitiveSet::LooseVertices; 2];
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
