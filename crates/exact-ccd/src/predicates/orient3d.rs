//! The side of a plane on which a point lies.

use core::cmp::Ordering;

use super::determinant::{determinant, permanent, sign_in_integers, sign_of_determinant};
use crate::environment;
use crate::filter::{UNIT, certain_sign};
use crate::point::Point;
use crate::query::NonFinite;

/// The sign of the volume of the tetrahedron a b c d, exactly: that of (b − a) · ((c − a) × (d − a)).
///
/// It is `Greater` if a, b and c turn counterclockwise as seen from d, `Less` if they turn
/// clockwise, and `Equal` if all four points lie in one plane.
///
/// ```
/// use core::cmp::Ordering;
/// use exact_ccd::predicates::orient3d;
///
/// let tetrahedron = [[0.0; 3], [1e-120, 0.0, 0.0], [0.0, 1e-120, 0.0], [0.0, 0.0, 1e-120]];
/// assert_eq!(orient3d(tetrahedron)?, Ordering::Greater);
/// # Ok::<(), exact_ccd::NonFinite>(())
/// ```
///
/// # Errors
/// [`NonFinite`] names the first coordinate that is infinite or not a number.
pub fn orient3d(points: [Point; 4]) -> Result<Ordering, NonFinite> {
    NonFinite::check(&points)?;
    Ok(sign_of_volume(&points))
}

/// [`orient3d`] of points that are finite.
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
