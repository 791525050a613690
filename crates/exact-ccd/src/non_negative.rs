//! Numbers that are not negative, in an order that no floating-point environment changes.

use core::fmt;

/// A finite f64 of at least 0, compared by its bits: these are in the order of the numbers. A
/// floating-point comparison may read subnormal numbers as zero.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct NonNegative(u64);

impl NonNegative {
    pub(crate) const ZERO: Self = Self(0);

    /// The number x; `None` if it is negative, infinite or NaN. −0.0 is 0.
    #[inline]
    pub(crate) fn new(x: f64) -> Option<Self> {
        let magnitude = x.to_bits() & !(1 << 63);
        (x.is_finite() && (x.is_sign_positive() || magnitude == 0)).then_some(Self(magnitude))
    }

    #[inline]
    pub(crate) fn get(self) -> f64 {
        f64::from_bits(self.0)
    }
}

impl fmt::Debug for NonNegative {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.get().fmt(f)
    }
}
