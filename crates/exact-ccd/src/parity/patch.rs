//! A bilinear patch and the origin (section 4.3 and appendix B of the paper).
//!
//! The patch with corners q₀ … q₃, in cyclic order, lies in their tetrahedron. At a point with
//! barycentric coordinates λᵢ there, φ = λ₀ λ₂ − λ₁ λ₃ vanishes exactly on the patch, is positive
//! on the faces that share the diagonal q₀ q₂ and negative on those that share q₁ q₃. The patch and
//! either pair of faces bound a region. A ray from the origin crosses its boundary an even number
//! of times, if the origin is not inside of it; then the crossings with the pair stand for those
//! with the patch.
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
//! - All are zero: the origin is in the plane of a flat tetrahedron. It may be on the patch; if
//!   not, no ray that leaves the plane meets it.

use core::cmp::Ordering;

use super::corner::Corner;
use super::planar;

/// Two triangles that a ray from the origin crosses as often as the patch, mod 2.
pub(super) type Pair = [[usize; 3]; 2];

/// The faces of the tetrahedron opposite q₁ and q₃, on which φ ≥ 0, and those opposite q₀ and q₂,
/// on which φ ≤ 0.
const AROUND_02: Pair = [[0, 2, 3], [0, 1, 2]];
const AROUND_13: Pair = [[1, 2, 3], [0, 1, 3]];

/// The triangles that replace a patch, as indices of its corners; `None` if the origin is on the
/// patch.
///
/// `is_near` is true if the origin is in the bounding box of the corners.
pub(super) fn stand_in<C: Corner>(corners: [&C; 4], is_near: bool) -> Option<Pair> {
    if !is_near {
        return Some(AROUND_02);
    }
    let [q0, q1, q2, q3] = corners;
    let mut weights = Ordering::Equal;
    for (index, [a, b, c]) in [[q0, q1, q2], [q0, q1, q3], [q0, q2, q3], [q1, q2, q3]]
        .into_iter()
        .enumerate()
    {
        let volume = C::orientation(a, b, c);
        let weight = if index % 2 == 0 { volume } else { volume.reverse() };
        if weight == weights.reverse() && weight.is_ne() {
            return Some(AROUND_02);
        }
        weights = weights.then(weight);
    }
    if weights.is_eq() {
        return (!planar::contains_origin(corners)).then_some(AROUND_02);
    }
    match C::phi(corners) {
        Ordering::Equal => None,
        Ordering::Greater => Some(AROUND_13),
        Ordering::Less => Some(AROUND_02),
    }
}
