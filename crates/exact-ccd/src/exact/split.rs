//! A time, as the ratio in which it splits the step.

use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::approximation::shifted;
use super::dyadic::{ENOUGH_BITS, decompose, rounded_down};

/// The time t with t / (1 − t) = a 2ᵏ / b for integers a, b ≥ 0 that are not both zero.
///
/// A time near either end of the step has few digits in this form, as an f64 has near 0.
#[derive(Clone, Debug)]
pub(crate) struct Split {
    /// a, in proportion to the time that has elapsed.
    pub(super) elapsed: IBig,
    /// b, in proportion to the time that is left. It is 1 unless the time is 1, or a given f64.
    pub(super) left: IBig,
    pub(super) exponent: isize,
}

impl Split {
    pub(crate) const START: Self = Self {
        elapsed: IBig::ZERO,
        left: IBig::ONE,
        exponent: 0,
    };
    pub(crate) const END: Self = Self {
        elapsed: IBig::ONE,
        left: IBig::ZERO,
        exponent: 0,
    };

    /// a 2ᵏ : 1 for a > 0.
    pub(super) fn ratio(elapsed: IBig, exponent: isize) -> Self {
        let zeros = elapsed.trailing_zeros().unwrap_or_default();
        Self {
            elapsed: elapsed >> zeros,
            left: IBig::ONE,
            exponent: exponent + zeros as isize,
        }
    }

    /// The value of `t`, which must lie in [0, 1].
    pub(crate) fn from_unit(t: f64) -> Self {
        let (mantissa, exponent) = decompose(t);
        // A number in [0, 1] has no bit above 2⁰: the exponent is not positive.
        let elapsed = IBig::from(mantissa);
        let left = (IBig::ONE << exponent.unsigned_abs() as usize) - &elapsed;
        Self {
            elapsed,
            left,
            exponent: 0,
        }
    }

    /// The bits of the largest f64 that is not above the time.
    pub(super) fn floor(&self) -> u64 {
        let elapsed = shifted(&self.elapsed, self.exponent.max(0));
        let whole = &elapsed + shifted(&self.left, (-self.exponent).max(0));
        let by = ENOUGH_BITS + whole.bit_len() as isize - elapsed.bit_len() as isize;
        let (floor, _) = rounded_down(&(shifted(&elapsed, by) / whole), -by);
        floor
    }

    /// Returns true if the time is 0 or 1.
    pub(super) fn is_end(&self) -> bool {
        self.elapsed.is_zero() || self.left.is_zero()
    }

    /// Returns true for a ratio a 2ᵏ : 1 that is not 0.
    pub(super) fn is_inner_ratio(&self) -> bool {
        self.left.is_one() && !self.elapsed.is_zero()
    }

    /// A k with 2ᵏ⁻² < a / b < 2ᵏ; the ends of the range of integers for the ends of the step.
    pub(super) fn top(&self) -> isize {
        if self.elapsed.is_zero() {
            isize::MIN
        } else if self.left.is_zero() {
            isize::MAX
        } else {
            self.exponent + 1 + self.elapsed.bit_len() as isize - self.left.bit_len() as isize
        }
    }
}

impl PartialEq for Split {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Split {}

impl Ord for Split {
    fn cmp(&self, other: &Self) -> Ordering {
        let tops = [self.top(), other.top()];
        if self.is_end() || other.is_end() || tops[0].abs_diff(tops[1]) > 2 {
            return tops[0].cmp(&tops[1]);
        }
        let least = self.exponent.min(other.exponent);
        let product = |x: &Self, y: &Self| (&x.elapsed * &y.left) << (x.exponent - least).unsigned_abs();
        product(self, other).cmp(&product(other, self))
    }
}

impl PartialOrd for Split {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
