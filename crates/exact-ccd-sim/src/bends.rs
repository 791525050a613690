//! The vertices at which rods bend.

/// The vertices of exactly two edges, each between the other ends of both.
///
/// A vertex at the end of a rod does not bend. Three and more edges at a vertex are hinged: no pair of them
/// is one rod.
pub(crate) fn bends(edges: &[[u32; 2]]) -> Vec<[u32; 3]> {
    let mut ends: Vec<[u32; 2]> = edges.iter().flat_map(|&[a, b]| [[a, b], [b, a]]).collect();
    ends.sort_unstable();
    let pairs = ends
        .chunk_by(|[a, _], [b, _]| a == b)
        .filter_map(|chunk| match chunk {
            &[[vertex, a], [_, b]] if a != b => Some([a, vertex, b]),
            _ => None,
        });
    pairs.collect()
}
