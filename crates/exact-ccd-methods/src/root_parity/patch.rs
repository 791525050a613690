//! A bilinear patch, and the two triangles that stand for it.
//!
//! The patch lies in the tetrahedron of its corners and divides it into two regions; the faces
//! around one diagonal of the corners bound one, those around the other diagonal the other. A ray
//! from the origin crosses the patch as often, mod 2, as the two faces that bound the region in
//! which the origin is not.

use std::cmp::Ordering;

use super::image::{Image, Predicate};

/// The faces of the tetrahedron around the diagonal from corner 0 to corner 2, on which φ ≥ 0, and
/// those around the other one, on which φ ≤ 0.
const AROUND_02: [[usize; 3]; 2] = [[0, 1, 2], [0, 2, 3]];
const AROUND_13: [[usize; 3]; 2] = [[0, 1, 3], [1, 2, 3]];

/// The triangles that stand for a patch; `None` if the origin is on the patch.
///
/// With Vᵢ the volume of the corners but the i-th, V₀, −V₁, V₂, −V₃ are the barycentric coordinates
/// of the origin, up to a factor. If some are positive and some negative, the origin is outside of
/// the tetrahedron, and either two triangles will do. If all are zero, everything is in one plane.
/// Otherwise the sign of φ determines the region.
pub(super) fn stand_in(image: &impl Image, patch: [usize; 4]) -> Option<[[usize; 3]; 2]> {
    let [a, b, c, d] = patch;
    let pair = |pair: [[usize; 3]; 2]| Some(pair.map(|triangle| triangle.map(|corner| patch[corner])));
    let mut weights = Ordering::Equal;
    for volume in [[b, c, d], [a, d, c], [a, b, d], [a, c, b]] {
        let weight = image.sign(Predicate::Volume(volume));
        if weight.is_ne() && weight == weights.reverse() {
            return pair(AROUND_02);
        }
        weights = weights.then(weight);
    }
    if weights.is_eq() {
        return if image.flat_patch_contains_origin(patch) {
            None
        } else {
            pair(AROUND_02)
        };
    }
    match image.sign(Predicate::Phi(patch)) {
        Ordering::Equal => None,
        Ordering::Greater => pair(AROUND_13),
        Ordering::Less => pair(AROUND_02),
    }
}

/// True if the hull of four corners contains the origin, which is in one plane with them: if one of
/// the triangles of three corners does.
pub(super) fn hull_contains_origin(image: &impl Image, [a, b, c, d]: [usize; 4]) -> bool {
    [[a, b, c], [a, b, d], [a, c, d], [b, c, d]]
        .into_iter()
        .any(|triangle| triangle_contains_origin(image, triangle))
}

/// True if a triangle contains the origin, which is in its plane.
///
/// The areas of the origin with the three edges have one sign, as seen along any axis. If all are
/// zero, the corners are on a line through the origin, and it is between two of them, or not.
fn triangle_contains_origin(image: &impl Image, [a, b, c]: [usize; 3]) -> bool {
    let edges = [[a, b], [b, c], [c, a]];
    let mut is_flat = true;
    for axis in 0..3 {
        let areas = edges.map(|edge| image.sign(Predicate::Turn(axis, edge)));
        if areas.contains(&Ordering::Less) && areas.contains(&Ordering::Greater) {
            return false;
        }
        is_flat &= areas == [Ordering::Equal; 3];
    }
    !is_flat
        || edges
            .into_iter()
            .any(|edge| image.sign(Predicate::Dot(edge)).is_le())
}
