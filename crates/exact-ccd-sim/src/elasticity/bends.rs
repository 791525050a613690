//! The vertices at which rods bend.

/// The vertices of exactly two edges, each between the other ends of both, with the number of the first edge.
///
/// A vertex at the end of a rod does not bend. Three and more edges at a vertex are hinged: no pair of them
/// is one rod.
pub(crate) fn bends(edges: &[[u32; 2]]) -> Vec<(usize, [u32; 3])> {
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
