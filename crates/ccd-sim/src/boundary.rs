//! What the connectivity of elements tells.

/// The faces of tetrahedra of positive volume that belong to one of them only, seen from outside counterclockwise, in the order
/// of their sorted corners.
pub(crate) fn boundary(tetrahedra: &[[u32; 4]]) -> Vec<[u32; 3]> {
    let sides = |&[a, b, c, d]: &[u32; 4]| [[a, c, b], [a, b, d], [a, d, c], [b, c, d]];
    let sorted = |mut face: [u32; 3]| {
        face.sort_unstable();
        face
    };
    let mut faces: Vec<([u32; 3], [u32; 3])> = tetrahedra
        .iter()
        .flat_map(sides)
        .map(|face| (sorted(face), face))
        .collect();
    faces.sort_unstable();
    let once = faces
        .chunk_by(|(a, _), (b, _)| a == b)
        .filter(|chunk| chunk.len() == 1);
    once.map(|chunk| chunk[0].1).collect()
}

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
