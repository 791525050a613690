//! The vertices at which rods bend, and the parts of rods between two ends.

use std::collections::{BTreeMap, BTreeSet};

/// The vertices of exactly two edges, each between the other ends of both, with the number of the first edge.
///
/// A vertex at the end of a rod does not bend. Three and more edges at a vertex are hinged: no pair of them
/// is one rod.
pub(crate) fn bending_vertices(edges: &[[u32; 2]]) -> Vec<(usize, [u32; 3])> {
    let numbered = edges.iter().enumerate();
    let mut ends: Vec<(u32, u32, usize)> = numbered
        .flat_map(|(edge, &[a, b])| [(a, b, edge), (b, a, edge)])
        .collect();
    ends.sort_unstable();
    let pairs = ends.chunk_by(|a, b| a.0 == b.0).filter_map(|chunk| match chunk {
        &[(vertex, a, first), (_, b, second)] if a != b => Some((first.min(second), [a, vertex, b])),
        _ => None,
    });
    pairs.collect()
}

/// The chains of at least two edges between vertices of one edge, or of three and more, each by its vertices
/// in their order. Each chain is in one direction. A closed loop of vertices of two edges has no ends.
pub(crate) fn paths_between_ends(edges: &[[u32; 2]]) -> Vec<Vec<u32>> {
    let mut neighbors: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    for &[a, b] in edges {
        neighbors.entry(a).or_default().insert(b);
        neighbors.entry(b).or_default().insert(a);
    }
    let is_end = |vertex: u32| neighbors[&vertex].len() != 2;
    let mut chains = Vec::new();
    for &end in neighbors.keys().filter(|&&vertex| is_end(vertex)) {
        for &next in &neighbors[&end] {
            let mut chain = vec![end, next];
            while let [.., before, last] = chain[..]
                && !is_end(last)
            {
                // A vertex of two edges has one other neighbor.
                chain.extend(neighbors[&last].iter().find(|&&other| other != before));
            }
            // The other direction is found from the other end.
            let is_first = chain.iter().le(chain.iter().rev());
            if chain.len() > 2 && is_first {
                chains.push(chain);
            }
        }
    }
    chains
}
