//! Signs in f64, and exact signs where an error bound leaves the sign open.

use std::cmp::Ordering;

use exact_ccd::Point;
use geometry_predicates::{orient2d, orient3d};

use super::approximate::Approximate;
use super::image::{Image, Predicate, Vectors, integers};
use crate::vector::products;

/// An image whose vectors are exactly f64, in the range (`Expansion::can_hold`) of the
/// predicates.
pub(super) struct Floats(Vectors<Approximate>);

impl Floats {
    /// The image of corners, with a ray.
    #[inline]
    pub(super) fn new(corners: &[Point; 8], ray: Point) -> Self {
        // A loop: closures of long arrays are not inlined.
        let mut vectors = [ray.map(Approximate::from); 9];
        for (vector, corner) in vectors.iter_mut().zip(corners) {
            *vector = corner.map(Approximate::from);
        }
        Self(vectors)
    }

    /// The sign by Shewchuk's adaptive predicates (Adaptive precision floating-point arithmetic and fast
    /// robust geometric predicates, 1997), which are exact in the range, or in integers.
    #[cold]
    fn sign_near_zero(&self, predicate: Predicate) -> Ordering {
        if predicate.vanishes(&self.0) {
            return Ordering::Equal;
        }
        let vector = |index: usize| self.0[index].map(|x| x.value);
        let exactly = |index: usize| [vector(index), [0.0; 3]];
        let determinant = match predicate {
            Predicate::Volume([a, b, c]) => orient3d(vector(a), vector(b), vector(c), [0.0; 3]),
            Predicate::Turn(axis, ends) => {
                let along = |point: Point| [point[(axis + 1) % 3], point[(axis + 2) % 3]];
                let [a, b] = ends.map(|end| along(vector(end)));
                orient2d(a, b, [0.0; 2])
            }
            Predicate::Dot(ends) => return Predicate::Dot([0, 1]).sign(&integers(&ends.map(exactly))),
            Predicate::Phi(patch) => {
                return Predicate::Phi([0, 1, 2, 3]).sign(&integers(&patch.map(exactly)));
            }
        };
        determinant.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
    }
}

impl Image for Floats {
    #[inline(always)]
    fn sign(&self, predicate: Predicate) -> Ordering {
        let sign = if let Predicate::Turn(axis, [a, b]) = predicate {
            // Rounding is monotone: if the rounded products differ, so do the exact ones, in the same sense.
            let [forth, back] = products(axis, &self.0[a], &self.0[b]).map(|product| product.value);
            if forth > back {
                Some(Ordering::Greater)
            } else if forth < back {
                Some(Ordering::Less)
            } else {
                (forth == 0.0).then_some(Ordering::Equal)
            }
        } else {
            predicate.value(&self.0).sign()
        };
        sign.unwrap_or_else(|| self.sign_near_zero(predicate))
    }
}

#[cfg(test)]
mod tests {
    use proptest::array::{uniform3, uniform4};
    use proptest::prelude::*;

    use super::*;
    use crate::parity::expansion::Expansion;
    use crate::parity::intervals::Intervals;

    fn combine<const N: usize>(factors: [f64; N], vectors: [Point; N]) -> Point {
        [0, 1, 2].map(|axis: usize| (0..N).map(|i| factors[i] * vectors[i][axis]).sum())
    }

    fn vectors() -> impl Strategy<Value = [Point; 4]> {
        let power = (-100..=140).prop_map(|exponent| 2f64.powi(exponent));
        let coordinate = prop_oneof![
            8 => -1.0..1.0,
            4 => (-2..=2i8).prop_map(f64::from),
            1 => power,
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
        let unit = prop_oneof![2 => Just(0), 1 => -20..=20].prop_map(|exponent| 2f64.powi(exponent));
        let is_in_range = |corners: &[Point; 4]| Expansion::can_hold(corners);
        (special(), uniform4(uniform3(steps)), uniform3(unit))
            .prop_map(|(corners, steps, units)| {
                let coordinate =
                    |i: usize, axis: usize| nudged(corners[i][axis], steps[i][axis]) * units[axis];
                [0, 1, 2, 3].map(|i| [0, 1, 2].map(|axis| coordinate(i, axis)))
            })
            .prop_filter("in range", is_in_range)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(50_000))]

        /// Also where arithmetic in f64 cancels. In intervals and expansions too.
        #[test]
        fn signs_are_those_in_integers(corners in corners()) {
            let mut differences = [[[0.0; 3]; 2]; 9];
            for (difference, corner) in differences.iter_mut().zip(corners) {
                difference[0] = corner;
            }
            let mut points = [[0.0; 3]; 8];
            points[..4].copy_from_slice(&corners);
            let (floats, intervals) = (Floats::new(&points, [0.0; 3]), Intervals::new(&differences));
            let integers = integers(&differences);
            let turn = |axis: usize| Predicate::Turn(axis, [0, 1]);
            let predicates = [
                Predicate::Volume([0, 1, 2]), turn(0), turn(1), turn(2), Predicate::Dot([2, 3]),
                Predicate::Phi([0, 1, 2, 3]),
            ];
            for predicate in predicates {
                prop_assert_eq!(floats.sign(predicate), integers.sign(predicate));
                prop_assert_eq!(intervals.sign(predicate), integers.sign(predicate));
            }
        }
    }
}
