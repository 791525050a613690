//! On which side of a plane a point lies.

use core::cmp::Ordering;

use dashu_int::IBig;

use crate::exact::to_integers;
use crate::filter::UNIT;
use crate::parity::{Integers, certain_sign, determinant, is_safe, permanent, volume};
use crate::query::{NonFinite, Point};

/// The sign of the volume of the tetrahedron a b c d, exactly: that of (b − a) · ((c − a) × (d − a)).
///
/// It is `Greater` if a, b and c turn counterclockwise as seen from d, `Less` if they turn clockwise, and `Equal` if all
/// four points lie in one plane.
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
/// A filter: the differences are rounded once, and the operations on them make it n = 8 roundings. What underflows in a
/// product is off by up to 2⁻¹⁰⁷⁵, which only a coordinate of b − a can enlarge; differences do not underflow. An overflow
/// makes the bound infinite, and nothing certain.
pub(crate) fn sign_of_volume(points: &[Point; 4]) -> Ordering {
    const UNDERFLOW: f64 = f64::from_bits((1023 - 1000) << 52);
    let [a, b, c, d] = points;
    let from_a = |p: &Point| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    let (u, v, w) = (from_a(b), from_a(c), from_a(d));
    let enlarged = 1.0 + u[0].abs() + u[1].abs() + u[2].abs();
    let error = 16.0 * UNIT * permanent(&u, &v, &w) + UNDERFLOW * enlarged;
    certain_sign(determinant(u, v, w), error).unwrap_or_else(|| sign_near_zero(points))
}

/// Comparisons, then Shewchuk's adaptive predicate where no part of it can underflow or overflow, then integers.
#[cold]
fn sign_near_zero(points: &[Point; 4]) -> Ordering {
    let is_flat = |axis: usize| points.iter().all(|p| p[axis] == points[0][axis]);
    let coincide = |i: usize, j: usize| points[i] == points[j];
    if (0..3).any(is_flat) || (1..4).any(|i| (0..i).any(|j| coincide(i, j))) {
        return Ordering::Equal;
    }
    if points.as_flattened().iter().all(|&x| is_safe(x)) {
        let [a, b, c, d] = points.map(|[x, y, z]| robust::Coord3D { x, y, z });
        let volume = robust::orient3d(b, c, d, a);
        return volume.partial_cmp(&0.0).unwrap_or(Ordering::Equal);
    }
    let axes = [0, 1, 2].map(|axis: usize| to_integers(points.map(|p| p[axis])).0);
    let from_a = |i: usize| -> Integers { [0, 1, 2].map(|axis: usize| &axes[axis][i] - &axes[axis][0]) };
    volume([&from_a(1), &from_a(2), &from_a(3)]).cmp(&IBig::ZERO)
}
