//! The predicates of the parity counter: signs of determinants of corners of F, in f64 or in
//! integers.

use core::cmp::Ordering;

use dashu_int::IBig;

use crate::filter::{DoubleDouble, Number, ROUNDOFF, UNDERFLOW, UNIT, certain_sign, diagonal_separates};
use crate::point::Point;
use crate::predicates::{Integers, determinant, integers, permanent, sign_of_determinant, volume};

/// A vector from the origin to a corner, in exact coordinates.
pub(super) trait Corner: Sized {
    /// A vector of small integers.
    fn small(coordinates: [u32; 3]) -> Self;

    fn is_positive(&self, axis: usize) -> bool;

    fn is_negative(&self, axis: usize) -> bool;

    /// Returns true if a cheap filter proves that the origin is not in the hull of the corners.
    fn certainly_exclude_origin(_corners: &[Self; 8]) -> bool {
        false
    }

    /// Returns true if both lie on one line through the origin.
    fn are_parallel(a: &Self, b: &Self) -> bool {
        (0..3).all(|axis| Self::turn(axis, a, b).is_eq())
    }

    /// Returns true if the corner is the origin.
    fn is_zero(&self) -> bool {
        (0..3).all(|axis| !self.is_positive(axis) && !self.is_negative(axis))
    }

    /// Returns true if two corners whose turn is zero are on the same side of an axis, as seen
    /// along it, and not on it.
    fn are_on_one_ray(axis: usize, a: &Self, b: &Self) -> bool {
        let signs = |c: &Self| seen_along(axis).map(|k| (c.is_positive(k), c.is_negative(k)));
        signs(a) == signs(b) && signs(a) != [(false, false); 2]
    }

    /// The sign of a component of a × b: the side of that axis on which the line from a to b passes.
    fn turn(axis: usize, a: &Self, b: &Self) -> Ordering;

    /// The sign of a · (b × c): the orientation of three corners, as seen from the origin.
    fn orientation(a: &Self, b: &Self, c: &Self) -> Ordering;

    /// The sign of V₀ V₂ − V₁ V₃, where Vᵢ is the determinant of the corners but the i-th.
    fn phi(corners: [&Self; 4]) -> Ordering;

    /// The corners as integers, on each axis divided by a positive number.
    fn integers(corners: [&Self; 4]) -> [Integers; 4];
}

/// The two other axes, as seen along an axis, in the order of their turn.
pub(super) fn seen_along(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// The corners without the i-th, for each i.
fn faces<T: Copy>([q0, q1, q2, q3]: [T; 4]) -> [[T; 3]; 4] {
    [[q1, q2, q3], [q0, q2, q3], [q0, q1, q3], [q0, q1, q2]]
}

impl Corner for Point {
    fn small(coordinates: [u32; 3]) -> Self {
        coordinates.map(f64::from)
    }

    /// True if all are strictly on one side of a plane x = ±y, y = ±z or z = ±x. Comparisons are
    /// exact.
    #[inline]
    fn certainly_exclude_origin(corners: &[Self; 8]) -> bool {
        [[0, 1], [1, 2], [2, 0]]
            .into_iter()
            .any(|[i, j]| diagonal_separates(corners.iter().map(|corner| (corner[i], corner[j]))))
    }

    #[inline]
    fn is_positive(&self, axis: usize) -> bool {
        self[axis] > 0.0
    }

    #[inline]
    fn is_negative(&self, axis: usize) -> bool {
        self[axis] < 0.0
    }

    /// Rounding is monotone: if the rounded products differ, so do the exact ones, in the same sense.
    #[inline]
    fn turn(axis: usize, a: &Self, b: &Self) -> Ordering {
        let [next, last] = seen_along(axis);
        let (p, q) = (a[next] * b[last], a[last] * b[next]);
        // Without a branch for the sign, which would be hard to predict.
        if p != q {
            return if p > q { Ordering::Greater } else { Ordering::Less };
        }
        // Most zeros are of two kinds: a point at rest makes corners coincide, motion in a plane
        // makes them vanish on its axis.
        let coincide = (a[next] == b[next]) & (a[last] == b[last]);
        let vanish = |x: f64, y: f64| (x == 0.0) | (y == 0.0);
        if coincide | (vanish(a[next], b[last]) & vanish(a[last], b[next])) {
            return Ordering::Equal;
        }
        let mut along = [0.0; 3];
        along[axis] = 1.0;
        orientation_near_zero(&along, a, b)
    }

    /// A filter (n = 5 roundings of exact input), then the adaptive determinant.
    ///
    /// The underflow in a product is at most 2⁻¹⁰⁷⁵, and only a coordinate of `a` can enlarge it:
    /// to far less than 2⁻¹⁰⁰⁰ times one plus their sum. An overflow makes the bound infinite, and
    /// no sign certain.
    #[inline(always)]
    fn orientation(a: &Self, b: &Self, c: &Self) -> Ordering {
        const UNDERFLOW: f64 = f64::from_bits((1023 - 1000) << 52);
        let enlarged = 1.0 + a[0].abs() + a[1].abs() + a[2].abs();
        let error = 8.0 * UNIT * permanent(a, b, c) + UNDERFLOW * enlarged;
        certain_sign(determinant(*a, *b, *c), error).unwrap_or_else(|| orientation_near_zero(a, b, c))
    }

    /// A filter, then the same in twice the precision, then integers.
    fn phi(corners: [&Self; 4]) -> Ordering {
        certain_phi::<f64>(corners, 8.0 * UNIT)
            .or_else(|| certain_phi::<DoubleDouble>(corners, 16.0 * ROUNDOFF))
            .unwrap_or_else(|| Integers::phi(Self::integers(corners).each_ref()))
    }

    fn integers(corners: [&Self; 4]) -> [Integers; 4] {
        integers(corners)
    }
}

#[cold]
fn orientation_near_zero(a: &Point, b: &Point, c: &Point) -> Ordering {
    let coincide = |a: &Point, b: &Point| (a[0] == b[0]) & (a[1] == b[1]) & (a[2] == b[2]);
    let vanish_on = |axis: usize| (a[axis] == 0.0) & (b[axis] == 0.0) & (c[axis] == 0.0);
    if coincide(a, b) | coincide(b, c) | coincide(c, a) | vanish_on(0) | vanish_on(1) | vanish_on(2) {
        return Ordering::Equal;
    }
    sign_of_determinant([a, b, c, &[0.0; 3]])
}

/// The sign of φ, if it is certain in the arithmetic of T. Five operations lead to a volume with a
/// bound m; its error is at most `relative` m. The error of a product of two volumes is at most the
/// product of each bound with the other's error, the product of both errors, and `relative` of its
/// magnitude for the remaining operations.
fn certain_phi<T: Number<Real = f64>>(corners: [&Point; 4], relative: f64) -> Option<Ordering> {
    /// 2¹⁶⁰, so that products of six stay in the range of f64.
    const LARGEST: f64 = f64::from_bits((1023 + 160) << 52);
    if corners.into_iter().flatten().any(|x| x.abs() > LARGEST) {
        return None;
    }
    let exact = |corner: &Point| corner.map(|x| T::difference(x, 0.0));
    let [v0, v1, v2, v3] = faces(corners).map(|[a, b, c]| determinant(exact(a), exact(b), exact(c)));
    let bounds = faces(corners).map(|[a, b, c]| permanent(a, b, c));
    let errors = bounds.map(|bound| relative * bound + UNDERFLOW);
    let error = |i: usize, j: usize| {
        bounds[i] * errors[j] + (bounds[j] + errors[j]) * errors[i] + relative * bounds[i] * bounds[j]
    };
    certain_sign((v0 * v2 - v1 * v3).value(), error(0, 2) + error(1, 3) + UNDERFLOW)
}

impl Corner for Integers {
    fn small(coordinates: [u32; 3]) -> Self {
        coordinates.map(IBig::from)
    }

    fn is_positive(&self, axis: usize) -> bool {
        self[axis] > IBig::ZERO
    }

    fn is_negative(&self, axis: usize) -> bool {
        self[axis] < IBig::ZERO
    }

    fn turn(axis: usize, a: &Self, b: &Self) -> Ordering {
        let [next, last] = seen_along(axis);
        (&a[next] * &b[last]).cmp(&(&a[last] * &b[next]))
    }

    fn orientation(a: &Self, b: &Self, c: &Self) -> Ordering {
        volume([a, b, c]).cmp(&IBig::ZERO)
    }

    fn phi(corners: [&Self; 4]) -> Ordering {
        let [v0, v1, v2, v3] = faces(corners).map(volume);
        (v0 * v2).cmp(&(v1 * v3))
    }

    fn integers(corners: [&Self; 4]) -> [Integers; 4] {
        corners.map(Clone::clone)
    }
}

#[cfg(test)]
mod tests {
    use proptest::array::{uniform3, uniform4};
    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    use super::*;

    fn combine<const N: usize>(factors: [f64; N], vectors: [Point; N]) -> Point {
        [0, 1, 2].map(|axis: usize| (0..N).map(|i| factors[i] * vectors[i][axis]).sum())
    }

    fn vectors() -> impl Strategy<Value = [Point; 4]> {
        let power =
            prop_oneof![-1000..=1000, -330..=330, -170..=170].prop_map(|exponent| 2f64.powi(exponent));
        let coordinate = prop_oneof![
            8 => -1.0..1.0,
            4 => (-2..=2i8).prop_map(f64::from),
            1 => power,
            1 => any::<f64>().prop_filter("finite", |x| x.is_finite()),
        ];
        uniform4(uniform3(coordinate))
    }

    /// Vectors with the third in the plane of the first two, or with the fourth placed such that
    /// the patch contains the origin up to rounding.
    fn special() -> impl Strategy<Value = [Point; 4]> {
        let factors = [-2..=2i8, -2..=2i8].prop_map(|factors| factors.map(f64::from));
        let place = [1..=3u8, 1..=3u8].prop_map(|place| place.map(|n| f64::from(n) / 4.0));
        (vectors(), any::<[bool; 2]>(), factors, place).prop_map(
            |([a, b, mut c, mut d], [flat, near], factors, [s, r])| {
                if flat {
                    c = combine(factors, [a, b]);
                }
                if near {
                    let scale = -1.0 / ((1.0 - s) * r);
                    d = combine(
                        [(1.0 - s) * (1.0 - r), s * (1.0 - r), s * r].map(|x| x * scale),
                        [a, b, c],
                    );
                }
                [a, b, c, d]
            },
        )
    }

    fn nudged(x: f64, steps: i8) -> f64 {
        let next = if steps < 0 { f64::next_down } else { f64::next_up };
        (0..steps.unsigned_abs()).fold(x, |x, _| next(x))
    }

    /// Corners moved by a few units in the last place, with a separate unit on each axis.
    fn corners() -> impl Strategy<Value = [Point; 4]> {
        let steps = prop_oneof![3 => Just(0), 1 => -2..=2i8];
        let unit = prop_oneof![2 => Just(0), 1 => -200..=200, 1 => -900..=900]
            .prop_map(|exponent| 2f64.powi(exponent));
        let finite = |corners: &[Point; 4]| corners.as_flattened().iter().all(|x| x.is_finite());
        (special(), uniform4(uniform3(steps)), uniform3(unit))
            .prop_map(|(corners, steps, units)| {
                let coordinate =
                    |i: usize, axis: usize| nudged(corners[i][axis], steps[i][axis]) * units[axis];
                [0, 1, 2, 3].map(|i| [0, 1, 2].map(|axis| coordinate(i, axis)))
            })
            .prop_filter("finite", finite)
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            cases: 100_000,
            failure_persistence: None,
            rng_seed: RngSeed::Fixed(0),
            ..ProptestConfig::default()
        })]

        /// Also where arithmetic in f64 underflows, overflows or cancels.
        #[test]
        fn signs_are_those_in_integers(corners in corners()) {
            let integers = Point::integers(corners.each_ref());
            let ([a, b, c, _], [i, j, k, _]) = (corners.each_ref(), integers.each_ref());
            prop_assert_eq!(Point::orientation(a, b, c), Integers::orientation(i, j, k));
            for axis in 0..3 {
                prop_assert_eq!(Point::turn(axis, a, b), Integers::turn(axis, i, j));
            }
            prop_assert_eq!(Point::are_parallel(a, b), Integers::are_parallel(i, j));
            prop_assert_eq!(Point::phi(corners.each_ref()), Integers::phi(integers.each_ref()));
        }
    }
}
