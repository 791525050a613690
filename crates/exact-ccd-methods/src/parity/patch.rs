//! A bilinear patch and the origin (section 4.3 and appendix B of the paper).
//!
//! The patch with corners q₀ … q₃, in cyclic order, lies in their tetrahedron. At a point with barycentric
//! coordinates λᵢ there, φ = λ₀ λ₂ − λ₁ λ₃ vanishes exactly on the patch, is positive on the faces that
//! share the diagonal q₀ q₂ and negative on the faces that share q₁ q₃. The patch and either pair of faces
//! bound a region. A ray from the origin crosses its boundary an even number of times, if the origin is not
//! inside of it. Then the ray crosses the pair as often as the patch, mod 2.
//!
//! For the origin, λᵢ is (−1)ⁱ Vᵢ over the sum of these, where Vᵢ is the determinant of the corners
//! but the i-th. Hence the signs of the four Vᵢ decide:
//! - Some (−1)ⁱ Vᵢ are positive and some negative: the origin is not in the tetrahedron, and either
//!   pair serves. Or the tetrahedron is flat, and the origin not in its plane. Then a ray through
//!   that plane meets the patch as often, mod 2, as the closed curve q₀ q₁ q₂ q₃ winds around the
//!   point, and that is the sum, mod 2, of how often the curves around the two triangles of either
//!   pair do: each is crossed or not, and exclusive or is the sum.
//! - None is negative, or none positive, and not all are zero: the origin is in the tetrahedron,
//!   which is not flat, and the sign of φ determines the side.
//! - All are zero: the origin is in the plane of a flat tetrahedron. It may be on the patch, which is
//!   in the hull of the corners; if not, no ray that leaves the plane meets it.

use std::cmp::Ordering;

use super::image::{Image, Predicate};

/// The faces of the tetrahedron around the diagonal from corner 0 to corner 2, on which φ ≥ 0, and the faces
/// around the other diagonal, on which φ ≤ 0.
pub(super) const AROUND_02: [[usize; 3]; 2] = [[0, 1, 2], [0, 2, 3]];
const AROUND_13: [[usize; 3]; 2] = [[0, 1, 3], [1, 2, 3]];

/// The triangles that stand for a patch, as indices of its corners; `None` if the origin is on the patch.
///
/// `covers` is true for a patch that contains the origin. It is called only if the origin is in the hull of
/// the corners and in one plane with them.
#[inline]
pub(super) fn stand_in(
    image: &impl Image,
    patch: [usize; 4],
    covers: &impl Fn([usize; 4]) -> bool,
) -> Option<[[usize; 3]; 2]> {
    let [a, b, c, d] = patch;
    let mut weights = Ordering::Equal;
    for volume in [[b, c, d], [a, d, c], [a, b, d], [a, c, b]] {
        let weight = image.sign(Predicate::Volume(volume));
        if weight.is_ne() && weight == weights.reverse() {
            return Some(AROUND_02);
        }
        weights = weights.then(weight);
    }
    if weights.is_eq() {
        return (!flat_patch_contains_origin(image, patch, covers)).then_some(AROUND_02);
    }
    match image.sign(Predicate::Phi(patch)) {
        Ordering::Equal => None,
        Ordering::Greater => Some(AROUND_13),
        Ordering::Less => Some(AROUND_02),
    }
}

/// Returns true if a patch contains the origin, which is in one plane with its corners.
///
/// If just one of the two triangles beside a diagonal contains it, then it is not on the diagonal. So it is
/// on a side of the patch, or the sides wind around it an odd number of times, and the patch fills them.
/// Otherwise, it can be on the patch only if it is in the hull of the corners: in one of four triangles.
fn flat_patch_contains_origin(
    image: &impl Image,
    patch: [usize; 4],
    covers: &impl Fn([usize; 4]) -> bool,
) -> bool {
    let contains = |triangle: [usize; 3]| {
        let corners = triangle.map(|corner| patch[corner]);
        triangle_contains_origin(image, corners)
    };
    match AROUND_02.map(contains) {
        [true, false] | [false, true] => true,
        [true, true] => covers(patch),
        [false, false] => AROUND_13.into_iter().any(contains) && covers(patch),
    }
}

/// Returns true if a triangle contains the origin, which is in its plane.
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
