//! A part of the step, and the coefficients of polynomials there from their exact ones.
//!
//! Near a root that is almost a double or a triple one, a polynomial is far smaller than its coefficients,
//! and than their rounding errors. In a narrow window around it, the coefficients are as small as the
//! polynomial. They are computed exactly, by blossoms, and rounded only then.

use core::cmp::Ordering;

use super::cubic::Root;
use super::dyadic::Dyadic;
use super::length::{Area, Volume};
use super::wide::Wide;
use crate::time::ContactTime;

/// An integer of 512 bits.
///
/// [Coefficients of a cubic](super::length::Length) are below 2²⁵², three times one below 2²⁵⁴, and three
/// weights, which add up to 2⁶² for each argument of the blossom, make them 2¹⁸⁶ times as large. Three times
/// that is below 2⁴⁴², and [without roots at the ends](super::zeros::without_ends) below 2⁴⁴⁵.
pub(super) type Integer = Wide<8>;

/// An interval of times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Window {
    low: Dyadic,
    high: Dyadic,
}

impl Window {
    /// All of the step.
    pub(super) const STEP: Self = Self {
        low: Dyadic::START,
        high: Dyadic::END,
    };

    /// The window between two times, of which the first is less.
    pub(super) fn new(low: Dyadic, high: Dyadic) -> Option<Self> {
        (low < high).then_some(Self { low, high })
    }

    pub(super) fn ends(&self) -> [Dyadic; 2] {
        [self.low, self.high]
    }

    /// The number of units from end to end.
    pub(super) fn units(&self) -> i64 {
        self.high.units() - self.low.units()
    }

    /// The length of this window, rounded.
    pub(super) fn width(&self) -> f64 {
        self.units() as f64 / Dyadic::END.units() as f64
    }

    /// The time at a place of this window, from 0 to 1; within four roundings.
    pub(super) fn time_at(&self, place: f64) -> f64 {
        self.low.units() as f64 / Dyadic::END.units() as f64 + place * self.width()
    }

    /// The units from the beginning of this window to a place, rounded down, and true if that is exact.
    ///
    /// A place is m 2⁻ᵏ, with m below 2⁵³, and a window has at most 2⁶² units: the product is below 2¹¹⁵.
    fn units_at(&self, place: f64) -> (i64, bool) {
        const BITS: u32 = f64::MANTISSA_DIGITS - 1;
        let bits = place.clamp(0.0, 1.0).to_bits();
        let exponent = (bits >> BITS) as u32;
        let mantissa = i128::from(bits & ((1 << BITS) - 1) | 1 << BITS);
        // Places below 2⁻⁶⁴, zero included, are less than a unit.
        let shift = 1023 + BITS - exponent;
        if shift > BITS + 64 {
            return (0, place <= 0.0);
        }
        let product = mantissa * i128::from(self.units());
        let floor = product >> shift;
        (floor as i64, floor << shift == product)
    }

    /// The last time that is not after a place of this window.
    pub(super) fn floor(&self, place: f64) -> Dyadic {
        self.low.plus(self.units_at(place).0)
    }

    /// Returns true if a time is before a place of this window.
    pub(super) fn is_before(&self, time: Dyadic, place: f64) -> bool {
        let (floor, is_exact) = self.units_at(place);
        let units = time.units() - self.low.units();
        units < floor || units == floor && !is_exact
    }

    /// The coefficients of c₀ (1−t)³ + c₁ (1−t)² t + c₂ (1−t) t² + c₃ t³ in this window, in the same form and
    /// some unit.
    pub(super) fn cubic(&self, cubic: &[Volume; 4]) -> [Integer; 4] {
        if *self == Self::STEP {
            return cubic.map(Wide::widened);
        }
        let (low, high) = (self.low, self.high);
        let value = |times| blossom(of_cubic(cubic), times);
        let second = value([low, low, high]);
        let third = value([low, high, high]);
        [
            value([low, low, low]),
            second.times(3),
            third.times(3),
            value([high, high, high]),
        ]
    }

    /// The coefficients of q₀ (1−t)² + q₁ (1−t) t + q₂ t² in this window, rounded, in the same form and some
    /// unit.
    pub(super) fn quadratic<A: Area>(&self, quadratic: [A; 3]) -> [f64; 3] {
        if *self == Self::STEP {
            return quadratic.map(A::value);
        }
        let (low, high) = (self.low, self.high);
        let value = |times| blossom(of_quadratic(quadratic), times);
        let [start, middle, end] = [[low, low], [low, high], [high, high]].map(value);
        [start, middle + middle, end].map(|q| q.approximate().high)
    }

    /// The time of the root of a cubic in a bracket of this window: an f64 there at which the cubic vanishes,
    /// or between two adjacent ones.
    ///
    /// The bracket has no other root, and the cubic opposite signs at its ends.
    pub(super) fn time(&self, cubic: &[Volume; 4], root: &Root) -> Option<ContactTime> {
        const STEPS: usize = 8;
        let below = if root.rising {
            Ordering::Less
        } else {
            Ordering::Greater
        };
        let mut floor = self.floor(root.low).floor();
        for _ in 0..STEPS {
            let next = floor.next_up();
            let dyadic = Dyadic::new(next)?;
            if !self.is_before(dyadic, root.high) {
                return Some(ContactTime::just_above(floor));
            }
            let sign = sign_at(cubic, dyadic);
            if sign.is_eq() {
                return Some(ContactTime::exactly(next));
            }
            if sign != below {
                return Some(ContactTime::just_above(floor));
            }
            floor = next;
        }
        None
    }
}

/// The sign of c₀ (1−t)³ + c₁ (1−t)² t + c₂ (1−t) t² + c₃ t³ at a time.
pub(super) fn sign_at(cubic: &[Volume; 4], time: Dyadic) -> Ordering {
    blossom(of_cubic(cubic), [time; 3]).sign()
}

/// The sign of q₀ (1−t)² + q₁ (1−t) t + q₂ t² at a time.
pub(super) fn quadratic_sign_at<A: Area>(quadratic: [A; 3], time: Dyadic) -> Ordering {
    blossom(of_quadratic(quadratic), [time; 2]).sign()
}

/// Three times its Bernstein coefficients.
fn of_cubic([c0, c1, c2, c3]: &[Volume; 4]) -> [Integer; 4] {
    let [c0, c1, c2, c3] = [c0, c1, c2, c3].map(|c| c.widened());
    [c0 + c0 + c0, c1, c2, c3 + c3 + c3]
}

/// Twice its Bernstein coefficients: [areas](super::length::Length) are below 2¹⁶⁷, and two weights of the
/// blossom make these 2¹²⁴ times as large, less than 2²⁹².
fn of_quadratic<A: Area>(quadratic: [A; 3]) -> [Wide<5>; 3] {
    let [q0, q1, q2] = quadratic.map(|q| q.widened().widened());
    [q0 + q0, q1, q2 + q2]
}

/// The blossom of the polynomial with these Bernstein coefficients, times 2⁶² for each argument: one
/// interpolation after another.
fn blossom<const W: usize, const N: usize, const D: usize>(
    mut b: [Wide<W>; N],
    times: [Dyadic; D],
) -> Wide<W> {
    for (count, [left, elapsed]) in (1..N).rev().zip(times.map(Dyadic::weights)) {
        for i in 0..count {
            b[i] = b[i].times(left) + b[i + 1].times(elapsed);
        }
    }
    b[0]
}
