//! Two times whose ratios are integers times powers of two, and times between them.

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::split::Split;

impl Split {
    /// A time strictly between `low` < `high`. It bisects the logarithms of the ratios while these are far
    /// apart, and the ratios then, so that a root near an end of the step takes few bisections.
    pub(super) fn between(low: &Self, high: &Self) -> Self {
        let tops = [low.top(), high.top()];
        match tops {
            [isize::MIN, isize::MAX] => Self::ratio(IBig::ONE, 0),
            [isize::MIN, above] => Self::ratio(IBig::ONE, (2 * above).min(0) - 3),
            [below, isize::MAX] => Self::ratio(IBig::ONE, (2 * below).max(0) + 3),
            [below, above] if above - below > 3 => Self::ratio(IBig::ONE, (below + above) / 2 - 1),
            _ => Self::on_grid(low, high, &IBig::ONE, 1),
        }
    }

    /// The time with ratio (self − earlier) / 2ᵏ.
    pub(super) fn after(&self, earlier: &Self, exponent: isize) -> Self {
        let ([earlier, this], own) = Self::align(earlier, self);
        Self::ratio(this - earlier, own - exponent)
    }

    /// The numbers a of two ratios a 2ᵏ : 1 with the same k, and k.
    fn align(low: &Self, high: &Self) -> ([IBig; 2], isize) {
        let exponent = low.exponent.min(high.exponent);
        let scaled = |x: &Self| &x.elapsed << (x.exponent - exponent).unsigned_abs();
        ([scaled(low), scaled(high)], exponent)
    }

    /// A k ≥ 0 such that the ratios of `low` < `high` differ by at most 2⁻ᵏ of a power of two above the
    /// latter; 0 only if they are far apart.
    pub(super) fn closeness(low: &Self, high: &Self) -> usize {
        if low.is_end() || high.is_end() || high.top() - low.top() > 3 {
            return 0;
        }
        let ([low, high], _) = Self::align(low, high);
        let length = high.bit_len();
        length - (high - low).bit_len()
    }

    /// low + (high − low) index / 2ᵇ, for the ratios, rounded down by less than (high − low) / 2ᵇ⁺² to one
    /// of few digits.
    pub(super) fn on_grid(low: &Self, high: &Self, index: &IBig, bits: usize) -> Self {
        let ([low, high], exponent) = Self::align(low, high);
        let width = high - &low;
        let dropped = width.bit_len().saturating_sub(3);
        let digits = ((low << bits) + width * index) >> dropped;
        Self::ratio(digits, exponent - bits as isize + dropped as isize)
    }
}
