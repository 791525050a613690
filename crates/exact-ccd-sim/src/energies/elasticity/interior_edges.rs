//! The interior edges of a shell.

/// An edge between two faces.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InteriorEdge {
    /// The two ends of the edge, and the opposite corners of both faces.
    pub(crate) vertices: [u32; 4],
    /// True if both faces have the same orientation.
    pub(crate) is_oriented: bool,
}

/// The edges that exactly two faces share.
///
/// Their vertices are four: the two ends of the edge, the opposite corner of the face in which the
/// edge runs from its first end to its second, and the opposite corner of the other face.
pub(crate) fn interior_edges(faces: &[[u32; 3]]) -> Vec<InteriorEdge> {
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
            // If both faces have the edge in the same direction, their orientations differ, and the
            // angle is measured between one normal and the opposite of the other.
            [(_, [a, b, c]), (_, [p, q, d])] => Some(InteriorEdge {
                vertices: [*a, *b, *c, *d],
                is_oriented: [a, b] == [q, p],
            }),
            _ => None,
        });
    pairs.collect()
}
