//! Real numbers known to within a bound, in arithmetic of any precision.
//!
//! Ball arithmetic: a number is a middle and a bound on the distance from it, and each operation
//! computes both (van der Hoeven, Ball arithmetic, 2009; Johansson, Arb, 2017). It proves a sign or
//! does not know it. The precision rises until it does. The bound is a power of two, which costs a few
//! bits of precision: an operation at most two.

use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::{BitTest, DivEuclid};

use super::dyadic::Dyadic;

/// The least precision, in bits: products of two middles have two machine words.
pub(super) const LEAST_PRECISION: usize = 60;

/// A real number x with |x − m 2ᵉ| < 2ᵏ for the middle m, the exponent e and the error k, or the number
/// m 2ᵉ if there is no error.
#[derive(Clone, Debug)]
pub(super) struct Ball {
    middle: IBig,
    exponent: isize,
    error: Option<isize>,
}

/// The first answer of a computation whose precision is doubled until it has one.
///
/// At a precision above the length of all integers in it, a computation rounds nothing, and no ball has
/// an error. Hence one that has an answer for exact numbers ends.
pub(super) fn with_precision<T>(mut precision: usize, computation: impl Fn(usize) -> Option<T>) -> T {
    loop {
        if let Some(answer) = computation(precision) {
            return answer;
        }
        precision = precision.saturating_mul(2);
    }
}

impl Ball {
    pub(super) const ZERO: Self = Self {
        middle: IBig::ZERO,
        exponent: 0,
        error: None,
    };

    /// An integer, rounded to a precision.
    pub(super) fn of(integer: &IBig, precision: usize) -> Self {
        let excess = integer.bit_len().saturating_sub(precision);
        Self {
            middle: integer >> excess,
            exponent: excess as isize,
            error: (excess > 0).then_some(excess as isize),
        }
    }

    /// A dyadic rational, rounded to a precision.
    pub(super) fn of_dyadic(x: &Dyadic, precision: usize) -> Self {
        Self::of(&x.numerator, precision).shifted(-(x.exponent as isize))
    }

    /// Any number between two dyadic rationals, low ≤ high.
    pub(super) fn between(low: &Dyadic, high: &Dyadic, precision: usize) -> Self {
        let width = Self::of_dyadic(&Dyadic::difference(high, low), precision);
        let start = Self::of_dyadic(low, precision);
        Self {
            error: sum(start.error, (!width.is_zero()).then(|| width.top())),
            ..start
        }
    }

    /// This number times 2ᵏ.
    pub(super) fn shifted(self, by: isize) -> Self {
        Self {
            middle: self.middle,
            exponent: self.exponent + by,
            error: self.error.map(|error| error + by),
        }
    }

    fn is_zero(&self) -> bool {
        self.middle.is_zero() && self.error.is_none()
    }

    /// The sign, if all numbers of the ball have it.
    pub(super) fn sign(&self) -> Option<Ordering> {
        self.is_known_to(0).then(|| self.middle.cmp(&IBig::ZERO))
    }

    /// Returns true if the error is at most 2⁻ᵏ of the middle.
    pub(super) fn is_known_to(&self, bits: usize) -> bool {
        // |m| 2ᵉ ≥ 2ᵗ⁻¹ for the top t, unless m = 0.
        let is_small = |error| !self.middle.is_zero() && error + (bits as isize) < self.top();
        self.error.is_none_or(is_small)
    }

    pub(super) fn plus(&self, other: &Self, precision: usize) -> Self {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        let unit = lowest(self.top().max(other.top()), precision);
        let unit = unit.max(self.exponent.min(other.exponent));
        let [a, b] = [self, other].map(|x| x.in_units(unit));
        Self {
            middle: a.middle + b.middle,
            exponent: unit,
            error: sum(a.error, b.error),
        }
    }

    pub(super) fn minus(&self, other: &Self, precision: usize) -> Self {
        let negative = Self {
            middle: -other.middle.clone(),
            ..*other
        };
        self.plus(&negative, precision)
    }

    /// |x y − m n| ≤ |m| |y − n| + |n| |x − m| + |x − m| |y − n|.
    pub(super) fn times(&self, other: &Self, precision: usize) -> Self {
        let by_self = other.error.map(|error| error + self.top());
        let by_other = self.error.map(|error| error + other.top());
        let by_both = self.error.zip(other.error).map(|(a, b)| a + b);
        let product = Self {
            middle: &self.middle * &other.middle,
            exponent: self.exponent + other.exponent,
            error: sum(sum(by_self, by_other), by_both),
        };
        let unit = lowest(product.top(), precision).max(product.exponent);
        product.in_units(unit)
    }

    /// The quotient of the middles, rounded to an integer; `None` for a divisor whose middle is 0.
    pub(super) fn quotient(&self, divisor: &Self) -> Option<IBig> {
        if divisor.middle.is_zero() {
            return None;
        }
        let shift = self.exponent - divisor.exponent + 1;
        let by = shift.unsigned_abs();
        let twice = if shift < 0 {
            (&self.middle).div_euclid(&divisor.middle << by)
        } else {
            (&self.middle << by).div_euclid(&divisor.middle)
        };
        Some((twice + IBig::ONE) >> 1)
    }

    /// The least k with |m| 2ᵉ < 2ᵏ, for m ≠ 0.
    pub(super) fn top(&self) -> isize {
        self.exponent + self.middle.bit_len() as isize
    }

    /// The same number with a middle in units of 2ᵏ. Bits that are shifted out are less than one unit.
    fn in_units(&self, unit: isize) -> Self {
        let shift = self.exponent - unit;
        let by = shift.unsigned_abs();
        let (middle, rounding) = if shift < 0 {
            (&self.middle >> by, Some(unit))
        } else {
            (&self.middle << by, None)
        };
        Self {
            middle,
            exponent: unit,
            error: sum(self.error, rounding),
        }
    }
}

/// The k with 2ᵃ + 2ᵇ ≤ 2ᵏ for the errors a and b.
fn sum(a: Option<isize>, b: Option<isize>) -> Option<isize> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.max(b) + 1),
        _ => a.or(b),
    }
}

/// The exponent of the last bit of a number of this precision with this top.
fn lowest(top: isize, precision: usize) -> isize {
    top.saturating_sub_unsigned(precision)
}
