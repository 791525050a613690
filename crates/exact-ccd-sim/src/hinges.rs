//! Where the triangles of a shell meet.

/// The edges that two faces share, as two ends and the other corners of the two faces: of the face in which the edge
/// runs from its first end to its second, then of the other.
pub(crate) fn hinges(faces: &[[u32; 3]]) -> Vec<[u32; 4]> {
    let sides = |&[a, b, c]: &[u32; 3]| [[a, b, c], [b, c, a], [c, a, b]];
    let mut sides: Vec<([u32; 2], [u32; 3])> = faces
        .iter()
        .flat_map(sides)
        .map(|side| ([side[0].min(side[1]), side[0].max(side[1])], side))
        .collect();
    sides.sort_unstable();
    let pairs = sides
        .chunk_by(|(a, _), (b, _)| a == b)
        .filter_map(|chunk| match chunk {
            // Where both faces have it in the same direction, they are oriented differently, and the angle is that between
            // one and the other's back.
            [(_, [a, b, c]), (_, [.., d])] => Some([*a, *b, *c, *d]),
            _ => None,
        });
    pairs.collect()
}
