//! Closed surfaces with one side only, which have no free positions.

use exact_ccd_mesh::{CanCollide, TriangleMesh};

/// A face of a closed surface that cannot be oriented, the first one, if there is such a surface.
///
/// A *surface* is here a set of faces that common edges connect, closed if each of their edges has exactly
/// two faces. If no choice of orientations makes neighbours run through their common edges in opposite
/// directions, its second cohomology group with integer coefficients is ℤ/2. The second cohomology group of a
/// compact set X in space is isomorphic to the reduced group of components of the complement of X in the
/// sphere (Alexander duality), which has no torsion. So the surface does not embed, even if several of its
/// parts meet in a vertex. Positions in which the mesh is free would be an embedding: see
/// [`Meeting`](exact_ccd_mesh::Meeting); faces without an area get one by a small displacement, after which
/// the mesh is still free. A surface is passed over if some of its pairs may intersect.
pub(crate) fn one_sided_surface(mesh: &TriangleMesh, can_collide: &CanCollide) -> Option<u32> {
    let faces = mesh.faces();
    let mut sides = Vec::with_capacity(3 * faces.len());
    for (face, &[a, b, c]) in (0..).zip(faces) {
        let of_face = [[a, b], [b, c], [c, a]];
        sides.extend(of_face.map(|[a, b]| ([a.min(b), a.max(b)], face, a < b)));
    }
    sides.sort_unstable();
    let mut is_closed = vec![true; faces.len()];
    // For each face, its neighbours, and true if they run through the common side in opposite directions.
    let mut neighbours: Vec<Vec<(u32, bool)>> = vec![Vec::new(); faces.len()];
    for side in sides.chunk_by(|(side, ..), (other, ..)| side == other) {
        match *side {
            [([a, b], first, along), (_, second, other)] if a != b && first != second => {
                neighbours[first as usize].push((second, along != other));
                neighbours[second as usize].push((first, along != other));
            }
            _ => {
                for &(_, face, _) in side {
                    is_closed[face as usize] = false;
                }
            }
        }
    }
    // True for a face that keeps its orientation, false for one that is turned over.
    let mut kept: Vec<Option<bool>> = vec![None; faces.len()];
    (0..faces.len() as u32).find(|&start| {
        if kept[start as usize].is_some() {
            return false;
        }
        kept[start as usize] = Some(true);
        let (mut reached, mut all_closed, mut is_oriented) = (vec![start], true, true);
        let mut vertices = Vec::new();
        while let Some(face) = reached.pop() {
            vertices.extend(faces[face as usize]);
            all_closed &= is_closed[face as usize];
            for &(other, is_opposite) in &neighbours[face as usize] {
                let wanted = kept[face as usize].map(|kept| kept == is_opposite);
                match kept[other as usize] {
                    None => {
                        kept[other as usize] = wanted;
                        reached.push(other);
                    }
                    found => is_oriented &= found == wanted,
                }
            }
        }
        all_closed && !is_oriented && are_examined(vertices, can_collide)
    })
}

/// Returns true if all pairs of a surface can collide: a predicate that allows two vertices allows the
/// primitives with these vertices, too.
fn are_examined(mut vertices: Vec<u32>, can_collide: &CanCollide) -> bool {
    vertices.sort_unstable();
    vertices.dedup();
    let others = |(place, &a): (usize, &u32)| {
        vertices[place + 1..]
            .iter()
            .all(|&b| can_collide.allows(&[a], &[b]))
    };
    can_collide.is_all() || vertices.iter().enumerate().all(others)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(faces: &[[u32; 3]]) -> Option<u32> {
        let mesh = TriangleMesh::new(12, faces.to_vec()).expect("the indices are in range");
        one_sided_surface(&mesh, &CanCollide::all())
    }

    const TETRAHEDRON: [[u32; 3]; 4] = [[6, 7, 8], [6, 7, 9], [7, 8, 9], [6, 8, 9]];

    /// The projective plane of six vertices: half of an icosahedron.
    const PROJECTIVE_PLANE: [[u32; 3]; 10] = [
        [0, 1, 2],
        [0, 2, 3],
        [0, 3, 4],
        [0, 4, 5],
        [0, 5, 1],
        [1, 2, 4],
        [2, 3, 5],
        [3, 4, 1],
        [4, 5, 2],
        [5, 1, 3],
    ];

    #[test]
    fn a_closed_surface_with_one_side_is_found_whatever_the_orientations() {
        assert_eq!(found(&TETRAHEDRON), None);
        assert_eq!(found(&PROJECTIVE_PLANE), Some(0));
        assert_eq!(
            found(&[&TETRAHEDRON[..], &PROJECTIVE_PLANE[..]].concat()),
            Some(4)
        );
        let mesh = TriangleMesh::new(12, PROJECTIVE_PLANE.to_vec()).expect("the indices are in range");
        for (obstacle, expected) in [(11, Some(0)), (5, None)] {
            let is_free = CanCollide::any_vertices(move |a, b| a.max(b) < obstacle);
            assert_eq!(one_sided_surface(&mesh, &is_free), expected);
        }
        // With a hole, it is a Möbius strip.
        assert_eq!(found(&PROJECTIVE_PLANE[1..]), None);
        // A face with two equal corners, and a side with three faces.
        assert_eq!(found(&[[0, 0, 1], [0, 1, 2]]), None);
        assert_eq!(found(&[&PROJECTIVE_PLANE[..], &[[0, 1, 11]]].concat()), None);
    }
}
