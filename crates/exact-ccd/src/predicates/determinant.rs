//! The determinant of three vectors: in floating point with an error bound, near zero, and in
//! integers.

use core::cmp::Ordering;

use dashu_int::IBig;

use crate::environment;
use crate::exact::to_integers;
use crate::point::Point;

/// A vector in integers.
type Integers = [IBig; 3];

/// a · (b × c), in five operations.
#[inline(always)]
pub(super) fn determinant(a: Point, b: Point, c: Point) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// The determinant of magnitudes, with sums in place of differences.
#[inline(always)]
pub(super) fn permanent(a: &Point, b: &Point, c: &Point) -> f64 {
    let [a, b, c] = [a, b, c].map(|v| v.map(f64::abs));
    a[0] * (b[1] * c[2] + b[2] * c[1])
        + a[1] * (b[2] * c[0] + b[0] * c[2])
        + a[2] * (b[0] * c[1] + b[1] * c[0])
}

/// The determinant in integers.
pub(super) fn volume([a, b, c]: [&Integers; 3]) -> IBig {
    let minor = |i: usize, j: usize| &b[i] * &c[j] - &b[j] * &c[i];
    &a[0] * minor(1, 2) + &a[1] * minor(2, 0) + &a[2] * minor(0, 1)
}

/// N points as vectors in integers, on each axis divided by a positive number.
pub(super) fn integers<const N: usize>(points: [&Point; N]) -> [Integers; N] {
    let axes = [0, 1, 2].map(|axis: usize| to_integers(points.map(|point| point[axis])).0);
    core::array::from_fn(|i| [0, 1, 2].map(|axis: usize| axes[axis][i].clone()))
}

/// The sign of (a − d) · ((b − d) × (c − d)): Shewchuk's adaptive predicate (Adaptive precision
/// floating-point arithmetic and fast robust geometric predicates, 1997) where all coordinates are
/// [safe](is_safe) and the environment is the default one, otherwise in integers.
pub(super) fn sign_of_determinant([a, b, c, d]: [&Point; 4]) -> Ordering {
    let points = [a, b, c, d];
    let are_safe = |point: &&Point| point.iter().fold(true, |all, &x| all & is_safe(x));
    if environment::is_default() && points.iter().all(are_safe) {
        let [a, b, c, d] = points.map(|&[x, y, z]| robust::Coord3D { x, y, z });
        let determinant = robust::orient3d(a, b, c, d);
        return determinant.partial_cmp(&0.0).unwrap_or(Ordering::Equal);
    }
    sign_in_integers(points)
}

/// The sign of (a − d) · ((b − d) × (c − d)) in integers, in any floating-point environment.
pub(super) fn sign_in_integers(points: [&Point; 4]) -> Ordering {
    let [a, b, c, d] = integers(points);
    let from_d = |p: &Integers| -> Integers { [0, 1, 2].map(|axis: usize| &p[axis] - &d[axis]) };
    volume([&from_d(&a), &from_d(&b), &from_d(&c)]).cmp(&IBig::ZERO)
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
                let points = [plus(u), plus(v), plus(w), d].map(|point| point.map(|x| x * unit));
                let sign = sign_of_determinant(points.each_ref());
                assert_eq!(sign, sign_in_integers(points.each_ref()), "{points:?}");
                counts[(sign as i8 + 1) as usize] += 1;
            }
        }
        assert!(counts.iter().all(|&count| count > 0), "{counts:?}");
    }
}
