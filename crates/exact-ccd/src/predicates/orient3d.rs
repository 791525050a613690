//! The side of a plane on which a point lies.

use core::cmp::Ordering;

use dashu_int::IBig;

use crate::environment;
use crate::exact::to_integers;
use crate::numbers::determinant::{determinant, error_of_determinant};
use crate::numbers::roundoff::certain_sign;
use crate::query::NonFinite;
use crate::tables::Point;

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
    NonFinite::check(&[&points])?;
    Ok(sign_of_volume(&points).reverse())
}

/// The sign of (b − a) · ((c − a) × (d − a)), of points that are finite.
///
/// An overflow makes the bound of the filter infinite, and no sign certain.
pub(crate) fn sign_of_volume(points: &[Point; 4]) -> Ordering {
    if !environment::is_default() {
        return sign_in_integers(points);
    }
    let [a, b, c, d] = points;
    let from_a = |p: &Point| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    let (u, v, w) = (from_a(b), from_a(c), from_a(d));
    certain_sign(determinant(u, v, w), error_of_determinant(u, v, w))
        .unwrap_or_else(|| sign_near_zero(points))
}

/// Comparisons, then Shewchuk's adaptive predicate (Adaptive precision floating-point arithmetic and fast
/// robust geometric predicates, 1997) where all coordinates are [safe](is_safe), otherwise integers.
#[cold]
fn sign_near_zero(points: &[Point; 4]) -> Ordering {
    let is_flat = |axis: usize| points.iter().all(|p| p[axis] == points[0][axis]);
    let coincide = |i: usize, j: usize| points[i] == points[j];
    if (0..3).any(is_flat) || (1..4).any(|i| (0..i).any(|j| coincide(i, j))) {
        return Ordering::Equal;
    }
    if !points.as_flattened().iter().all(|&x| is_safe(x)) {
        return sign_in_integers(points);
    }
    let [a, b, c, d] = points.map(|[x, y, z]| robust::Coord3D { x, y, z });
    let determinant = robust::orient3d(b, c, d, a);
    determinant.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}

/// The sign in integers, in any floating-point environment: rows and columns of the determinant change
/// places.
fn sign_in_integers(points: &[Point; 4]) -> Ordering {
    let [x, y, z] = [0, 1, 2].map(|axis: usize| {
        let ([a, b, c, d], _) = to_integers(points.map(|point| point[axis]));
        [b - &a, c - &a, d - &a]
    });
    let minor = |i: usize, j: usize| &y[i] * &z[j] - &y[j] * &z[i];
    let determinant = &x[0] * minor(1, 2) + &x[1] * minor(2, 0) + &x[2] * minor(0, 1);
    determinant.cmp(&IBig::ZERO)
}

/// Returns true if Shewchuk's predicate neither underflows nor overflows on four points of such
/// coordinates.
///
/// Coordinates are multiples of 2⁻²⁵⁰⁻⁵² = 2⁻³⁰², and so are their differences, rounded or not, and
/// the parts into which these are split. Products of two and three of them are multiples of 2⁻⁶⁰⁴
/// and 2⁻⁹⁰⁶ > 2⁻¹⁰⁷⁴, and none underflows. The permanent, unless it is zero, is at least 2⁻⁹⁰⁶.
/// The smallest error bound, 26 u² times the permanent with u = 2⁻⁵³, is at least 2⁻¹⁰⁰⁸ > 2⁻¹⁰²²:
/// it is a normal number, whose rounding is relative, as the bound assumes. In the other direction,
/// products of three differences, of which one is split by a factor of 2²⁷ + 1, add up to less than
/// 2⁹⁴⁰.
fn is_safe(x: f64) -> bool {
    const SMALLEST: f64 = f64::from_bits((1023 - 250) << 52);
    const LARGEST: f64 = f64::from_bits((1023 + 300) << 52);
    (x == 0.0) | ((x.abs() >= SMALLEST) & (x.abs() <= LARGEST))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A generator of pseudo-random bits (SplitMix64).
    struct Bits(u64);

    impl Bits {
        fn next(&mut self) -> u64 {
            self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = self.0;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^ (z >> 31)
        }

        /// A number of all 53 bits with a magnitude in [1, 2).
        fn fraction(&mut self) -> f64 {
            let sign = if self.next() & 1 == 0 { 1.0 } else { -1.0 };
            sign * f64::from_bits(1023 << 52 | self.next() >> 12)
        }
    }

    /// Points in one plane up to rounding, in units around the limits of the safe range: the error
    /// bounds of all stages of the predicate matter, and the differences are much smaller than the
    /// coordinates.
    #[test]
    fn signs_are_exact_at_the_limits_of_the_safe_range() {
        let mut bits = Bits(0);
        let mut counts = [0; 3];
        for exponent in (-360..=-230).chain(290..=310) {
            let unit = libm::ldexp(1.0, exponent);
            for _ in 0..100 {
                let d: Point = [0; 3].map(|_| bits.fraction());
                let spread = libm::ldexp(1.0, -((bits.next() % 50) as i32));
                let [u, v] = [0; 2].map(|_| [0; 3].map(|_| spread * bits.fraction()));
                let (r, s) = (bits.fraction(), bits.fraction());
                let plus = |w: [f64; 3]| [0, 1, 2].map(|axis: usize| d[axis] + w[axis]);
                let w = [0, 1, 2].map(|axis: usize| r * u[axis] + s * v[axis]);
                let points = [d, plus(u), plus(v), plus(w)].map(|point| point.map(|x| x * unit));
                let sign = sign_near_zero(&points);
                assert_eq!(sign, sign_in_integers(&points), "{points:?}");
                counts[(sign as i8 + 1) as usize] += 1;
            }
        }
        assert!(counts.iter().all(|&count| count > 0), "{counts:?}");
    }

    /// Products of c and d underflow, and the lost part times a component of b decides the sign.
    #[test]
    fn signs_are_exact_where_products_underflow_next_to_large_coordinates() {
        let tiny = libm::ldexp(1.0, -537);
        let large = libm::ldexp(1.0, 600);
        for factor in [8.0, -8.0] {
            let b = [factor * large, large, 0.0];
            let (c, d) = ([tiny, 1.375 * tiny, tiny], [0.0, tiny, tiny]);
            let points = [[0.0; 3], b, c, d];
            let sign = sign_of_volume(&points);
            assert_eq!(sign, sign_in_integers(&points));
            assert_eq!(sign, factor.total_cmp(&0.0));
        }
        for rotation in 0..3 {
            let turned = |mut point: Point| {
                point.rotate_right(rotation);
                point
            };
            let [x, y, z] = [590, 500, -455].map(|exponent| libm::ldexp(1.0, exponent));
            let b = turned([x, y, 0.0]);
            let (c, d) = (turned([0.0, 1.375 * tiny, tiny]), turned([-z, tiny, tiny]));
            assert_eq!(sign_of_volume(&[[0.0; 3], b, c, d]), Ordering::Greater);
        }
    }

    /// All three products of two components of c and d underflow.
    #[test]
    fn signs_are_exact_where_all_products_underflow() {
        let [r, s] = [-487, -100].map(|exponent| libm::ldexp(1.0, exponent));
        for sign in [1.0, -1.0] {
            let b = [1.375, -0.5625, -0.5625].map(|x| sign * s * x);
            let points = [[0.0; 3], b, [r, -r, 0.0], [0.0, r, -r]];
            assert_eq!(sign_of_volume(&points), sign.total_cmp(&0.0));
        }
    }
}
