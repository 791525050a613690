//! Cubics in twice the precision: a root is rounded to two adjacent f64 by signs on both sides of it.

use core::cmp::Ordering;
use core::ops::Mul;

use super::cubic::Root;
use super::double_double::{DoubleDouble, ROUNDOFF};
use super::number::Number;
use super::roundoff::{UNDERFLOW, certain_sign, margin};
use crate::values::ContactTime;

/// c(t) = a₀ + a₁ t + a₂ t² + a₃ t³.
pub(crate) struct PreciseCubic<T = DoubleDouble> {
    powers: [T; 4],
    /// A bound of the error of c(t) for all t in [0, 1].
    pub(crate) error: f64,
}

impl<T: Number<Real = f64> + Mul<f64, Output = T>> PreciseCubic<T> {
    /// The cubic of [`Cubic::new`](super::cubic::Cubic::new).
    ///
    /// Let m be `magnitude`. Differences are exact. Seven operations lead to the coefficients, at most three
    /// more to the powers, whose terms add up to m, 6 m, 12 m and 8 m, and six in Horner's scheme to a value:
    /// n = 16, on terms whose magnitudes add up to at most 27 m.
    pub(crate) fn new([b0, three_b1, three_b2, b3]: [T; 4], magnitude: f64) -> Self {
        let powers = [
            b0,
            three_b1 - b0 * 3.0,
            three_b2 - three_b1 * 2.0 + b0 * 3.0,
            b3 - three_b2 + three_b1 - b0,
        ];
        let error = margin(16) * ROUNDOFF * 27.0 * magnitude + UNDERFLOW;
        Self { powers, error }
    }

    pub(crate) fn value(&self, t: f64) -> T {
        let [a0, a1, a2, a3] = self.powers;
        ((a3 * t + a2) * t + a1) * t + a0
    }
}

impl PreciseCubic {
    /// Returns true if |c(t)| certainly is above a bound.
    ///
    /// The high part is the nearest f64 of the value, and the sum is the nearest f64 of the bound plus the
    /// error. Rounding is monotone: numbers whose nearest f64 are in strict order are so themselves.
    pub(crate) fn exceeds(&self, t: f64, bound: f64) -> bool {
        self.value(t).high.abs() > self.error + bound
    }

    /// The sign of c(t), if it is certainly not zero.
    pub(crate) fn sign_at(&self, t: f64) -> Option<Ordering> {
        self.sign(self.value(t))
    }

    /// The sign of a value, if it is certainly not zero.
    fn sign(&self, value: DoubleDouble) -> Option<Ordering> {
        certain_sign(value.high, self.error)
    }

    /// The root between two adjacent f64, if the signs of c at both are certain.
    pub(crate) fn round(&self, root: &Root) -> Option<ContactTime> {
        const STEPS: usize = 4;
        let mut floor = root.near;
        for _ in 0..STEPS {
            let value = self.value(floor);
            let newton = DoubleDouble::sum(floor, -value.high / root.slope);
            let next = if newton.low < 0.0 {
                newton.high.next_down()
            } else {
                newton.high
            };
            if next == floor {
                // Outside of the bracket, c may have other roots.
                if floor < root.low || floor.next_up() > root.high {
                    return None;
                }
                let above = self.sign_at(floor.next_up())?;
                let proved = self.sign(value)? == root.before && above == root.before.reverse();
                return proved.then(|| ContactTime::just_above(floor));
            }
            floor = next;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rounding of half a unit in the last place, above 1.
    const HALF: f64 = f64::EPSILON / 2.0;

    #[test]
    fn a_value_exceeds_a_bound_by_more_than_its_error() {
        // Multiples of a fourth of a unit in the last place: values next to the bound 3 / 2, and errors.
        let bound = 1.5;
        let mut exceeded = 0;
        for value in -16_i32..=16 {
            for error in 0..=16_i32 {
                let [above, by] = [value, error].map(|fourths| f64::from(fourths) * HALF / 2.0);
                let cubic = |sign: f64| PreciseCubic {
                    powers: [
                        DoubleDouble::sum(sign * bound, sign * above),
                        DoubleDouble::default(),
                        DoubleDouble::default(),
                        DoubleDouble::default(),
                    ],
                    error: by,
                };
                let exceeds = cubic(1.0).exceeds(0.5, bound);
                assert_eq!(exceeds, cubic(-1.0).exceeds(0.5, bound));
                assert!(!exceeds || value > error, "{value} of {error}");
                assert!(exceeds || value <= error + 4, "a unit in the last place suffices");
                exceeded += i32::from(exceeds);
            }
        }
        assert!(exceeded > 100, "{exceeded}");
    }

    #[test]
    fn a_root_is_rounded_or_unknown() {
        let mut rounded = 0;
        for (a, b) in (1_i32..40).flat_map(|a| (a + 1..60).map(move |b| (a, b))) {
            let sign = if (a + b) % 2 == 0 { 1.0 } else { -1.0 };
            let [a, b] = [a, b].map(f64::from);
            // (b t − a) (1 + t²), which vanishes at a / b only.
            let bernstein = [-a, b - 3.0 * a, 2.0 * b - 4.0 * a, 2.0 * b - 2.0 * a];
            let cubic = PreciseCubic::new(bernstein.map(|c| DoubleDouble::sum(sign * c, 0.0)), 2.0 * b);
            let nearest = a / b;
            // The sign of the remainder is exact: a fused operation has one rounding.
            let remainder = nearest.mul_add(b, -a);
            let floor = if remainder > 0.0 {
                nearest.next_down()
            } else {
                nearest
            };
            for width in [0.0, 1e-3] {
                // A slope that is a hundredth of the true one leads away from the root, one that is too large
                // leads nowhere.
                for (offset, factor) in [(0.0, 1.0), (1e-4, 1.0), (-1e-9, 1.0), (1e-4, 0.01), (-1e-4, 1e30)] {
                    let root = Root {
                        low: nearest - width,
                        high: nearest + width,
                        near: nearest + offset,
                        slope: sign * factor * b * (1.0 + nearest * nearest),
                        before: 0.0_f64.total_cmp(&sign),
                    };
                    let time = cubic.round(&root);
                    // No sign is certain where the cubic vanishes.
                    let is_certain = remainder != 0.0 && width > 0.0 && factor == 1.0;
                    let expected = is_certain.then(|| ContactTime::just_above(floor));
                    assert_eq!(time, expected, "{a} / {b}, {root:?}");
                    rounded += usize::from(time.is_some());
                }
            }
        }
        assert!(rounded > 1000, "{rounded}");
    }
}
