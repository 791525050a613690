//! Sums that are rounded outward in any floating-point environment.

use core::ops::{Add, Sub};

/// A format of floating-point numbers: f64, or a format so small that tests examine all of its numbers.
pub(crate) trait Format: Copy + Add<Output = Self> + Sub<Output = Self> {
    /// Four times the least normal number: above the effects of all that is flushed to zero in a sum.
    const FLUSHED: Self;

    /// True for +0, by its bits: a comparison may read a subnormal number as zero.
    fn is_zero(self) -> bool;

    /// Half of it, rounded.
    fn halved(self) -> Self;

    fn next_up(self) -> Self;

    fn next_down(self) -> Self;
}

impl Format for f64 {
    const FLUSHED: Self = 4.0 * Self::MIN_POSITIVE;

    #[inline(always)]
    fn is_zero(self) -> bool {
        self.to_bits() == 0
    }

    #[inline(always)]
    fn halved(self) -> Self {
        0.5 * self
    }

    #[inline(always)]
    fn next_up(self) -> Self {
        self.next_up()
    }

    #[inline(always)]
    fn next_down(self) -> Self {
        self.next_down()
    }
}

/// A number that is not below a + b.
///
/// fl(a + b) may lie below a + b, by less than one unit in the last place in any direction of rounding; the
/// next number above it does not. Where subnormal numbers are flushed to zero, a, b and the result are each
/// off by less than 2⁻¹⁰²²; [`Format::FLUSHED`] covers that.
#[inline(always)]
pub(crate) fn sum_above<F: Format>(a: F, b: F) -> F {
    (a + b).next_up() + F::FLUSHED
}

/// A number that is not above a − b, for the same reasons as [`sum_above`].
#[inline(always)]
pub(crate) fn difference_below<F: Format>(a: F, b: F) -> F {
    (a - b).next_down() - F::FLUSHED
}

#[cfg(test)]
pub(crate) mod small;
