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
    /// The other ends of the edges with these indices.
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

    /// Returns true if an edge of the vertex has no vertex in common with an edge that does not contain it.
    /// Returns true for an unknown vertex, too, because a broad phase may pass any pair on.
    pub(crate) fn has_edge_apart_from(&self, vertex: u32, edge: [u32; 2]) -> bool {
        let others = self.of.get(vertex as usize);
        let others = others.and_then(|(count, others)| others.get(..usize::from(*count)));
        others.is_none_or(|others| others.iter().any(|other| !edge.contains(other)))
    }
}

#[cfg(test)]
mod tests {
    use fastrand::Rng;

    use super::OtherEnds;
    use crate::mesh::TriangleMesh;

    #[test]
    fn vertices_have_edges_apart_from_others_by_the_definition() {
        let mut rng = Rng::with_seed(0);
        let (mut covered, mut uncovered) = (0, 0);
        for _ in 0..300 {
            let edges: Vec<[u32; 2]> = (0..rng.usize(..12))
                .map(|_| [rng.u32(..6), rng.u32(..6)])
                .collect();
            let mesh = TriangleMesh::with_edges(6, Vec::new(), &edges).expect("the indices are in range");
            let all: Vec<u32> = (0..mesh.edges().len() as u32).collect();
            let ends = OtherEnds::new(&mesh, &all);
            for vertex in 0..6 {
                let own: Vec<[u32; 2]> = mesh
                    .edges()
                    .iter()
                    .copied()
                    .filter(|edge| edge.contains(&vertex))
                    .collect();
                let mut is_uncovered = false;
                for &edge in mesh.edges().iter().filter(|edge| !edge.contains(&vertex)) {
                    let is_apart = own.iter().any(|own| !own.iter().any(|end| edge.contains(end)));
                    assert_eq!(
                        ends.has_edge_apart_from(vertex, edge),
                        is_apart,
                        "{vertex} {edge:?} {mesh:?}"
                    );
                    is_uncovered |= !is_apart;
                    *(if is_apart { &mut covered } else { &mut uncovered }) += 1;
                }
                assert_eq!(ends.is_loose(vertex), own.is_empty());
                assert_eq!(
                    ends.is_end(&mesh, vertex),
                    own.len() < 2 || is_uncovered,
                    "{vertex} {mesh:?}"
                );
            }
        }
        assert!(covered > 100 && uncovered > 100, "{covered} {uncovered}");
    }
}
