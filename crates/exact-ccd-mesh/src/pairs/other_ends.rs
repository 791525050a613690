//! The edges of each vertex, by their other ends.

use crate::mesh::TriangleMesh;

/// The other ends of the edges of each vertex, as far as they decide the pairs of a vertex and a loose edge.
///
/// Let a vertex p touch a loose edge e that does not contain it. If an edge of p is apart from e, without a
/// common vertex, then these two edges touch, and the pair of p and e is *covered*. Otherwise every edge of p
/// leads to an end of e: p has no edge, one, or two whose other ends e connects.
#[derive(Clone, Debug, Default)]
pub(crate) struct OtherEnds {
    /// The number of edges of each vertex, at most 3, and the other ends of two of them.
    of: Vec<(u8, [u32; 2])>,
}

impl OtherEnds {
    /// Those of the edges with these indices.
    pub(crate) fn new(mesh: &TriangleMesh, edges: &[u32]) -> Self {
        let mut of = vec![(0, [0; 2]); mesh.vertex_count()];
        let mut add = |vertex: u32, other: u32| {
            let (count, others): &mut (u8, [u32; 2]) = &mut of[vertex as usize];
            if let Some(place) = others.get_mut(usize::from(*count)) {
                *place = other;
            }
            *count = (*count + 1).min(3);
        };
        for &edge in edges {
            let [a, b] = mesh.edges()[edge as usize];
            add(a, b);
            add(b, a);
        }
        Self { of }
    }

    /// Returns true if a vertex has no edge.
    pub(crate) fn is_loose(&self, vertex: u32) -> bool {
        self.of[vertex as usize].0 == 0
    }

    /// Returns true if the pair of a vertex and an edge that does not contain it may not be covered.
    pub(crate) fn is_end(&self, mesh: &TriangleMesh, vertex: u32) -> bool {
        match self.of[vertex as usize] {
            (0 | 1, _) => true,
            (2, [a, b]) => mesh.edge(a, b).is_some(),
            _ => false,
        }
    }

    /// Returns true if an edge of the vertex has no vertex in common with an edge that does not contain it. A
    /// broad phase may pass any pair on: it is true for a vertex that is not one of these.
    pub(crate) fn has_edge_apart_from(&self, vertex: u32, edge: [u32; 2]) -> bool {
        let others = self.of.get(vertex as usize);
        let others = others.and_then(|(count, others)| others.get(..usize::from(*count)));
        others.is_none_or(|others| others.iter().any(|other| !edge.contains(other)))
    }
}
