//! The side of a plane on which a point lies.

use core::cmp::Ordering;

use super::determinant::{determinant, permanent, sign_in_integers, sign_of_determinant};
use crate::environment;
use crate::filter::{UNIT, certain_sign};
use crate::point::Point;
use crate::query::NonFinite;

/// The side of the plane through a, b and c on which d lies, exactly.
///
/// It is the sign of (a − d) · ((b − d) × (c − d)), that of Shewchuk's predicate of this name (Adaptive
/// precision floating-point arithmetic and fast robust geometric predicates, 1997).
///
/// It is `Less` if a, b and c turn counterclockwise as seen from d, `Greater` if they turn clockwise, and
/// `Equal` if all four points lie in one plane. So it is `Less` for a tetrahedron of positive volume
/// (b − a) · ((c − a) × (d − a)) / 6.
///
/// ```
/// use core::cmp::Ordering;
/// use exact_ccd::predicates::orient3d;
///
/// let [a, b, c] = [[0.0; 3], [1e-120, 0.0, 0.0], [0.0, 1e-120, 0.0]];
/// let above = [0.0, 0.0, 1e-120];
/// assert_eq!(orient3d([a, b, c, above])?, Ordering::Less);
/// # Ok::<(), exact_ccd::NonFinite>(())
/// ```
///
/// # Errors
/// [`NonFinite`] names the first coordinate that is infinite or not a number.
pub fn orient3d(points: [Point; 4]) -> Result<Ordering, NonFinite> {
    NonFinite::check(&points)?;
    Ok(sign_of_volume(&points).reverse())
}

/// The sign of (b − a) · ((c − a) × (d − a)), of points that are finite.
///
/// The filter: the differences are rounded once, and the operations on them make it n = 8
/// roundings. The underflow in a product is at most 2⁻¹⁰⁷⁵, which only a coordinate of b − a can
/// enlarge; differences do not underflow. An overflow makes the bound infinite, and no sign
/// certain.
pub(crate) fn sign_of_volume(points: &[Point; 4]) -> Ordering {
    const UNDERFLOW: f64 = f64::from_bits((1023 - 1000) << 52);
    let [a, b, c, d] = points;
    if !environment::is_default() {
        return sign_in_integers([b, c, d, a]);
    }
    let from_a = |p: &Point| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    let (u, v, w) = (from_a(b), from_a(c), from_a(d));
    let enlarged = 1.0 + u[0].abs() + u[1].abs() + u[2].abs();
    let error = 16.0 * UNIT * permanent(&u, &v, &w) + UNDERFLOW * enlarged;
    certain_sign(determinant(u, v, w), error).unwrap_or_else(|| sign_near_zero(points))
}

/// Comparisons, then the adaptive determinant.
#[cold]
fn sign_near_zero(points: &[Point; 4]) -> Ordering {
    let is_flat = |axis: usize| points.iter().all(|p| p[axis] == points[0][axis]);
    let coincide = |i: usize, j: usize| points[i] == points[j];
    if (0..3).any(is_flat) || (1..4).any(|i| (0..i).any(|j| coincide(i, j))) {
        return Ordering::Equal;
    }
    let [a, b, c, d] = points.each_ref();
    sign_of_determinant([b, c, d, a])
}
