//! Numbers that are not negative, in an order that no floating-point environment changes.

use core::fmt;

/// A finite f64 of at least 0, compared by its bits: these are in the order of the numbers. A
/// floating-point comparison may read subnormal numbers as zero.
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct NonNegative(u64);

/// The bits of −0.0. All larger bits belong to negative numbers or to NaN.
const NEGATIVE_ZERO: u64 = 1 << 63;

impl NonNegative {
    pub(crate) const ZERO: Self = Self(0);

    /// The number x; `None` if it is negative, infinite or NaN. −0.0 is 0.
    ///
    /// The bits are compared as a whole. The compiler replaces a test of the bits without the sign by a
    /// floating-point comparison with zero.
    #[inline]
    pub(crate) fn new(x: f64) -> Option<Self> {
        match x.to_bits() {
            NEGATIVE_ZERO => Some(Self::ZERO),
            bits if bits < f64::INFINITY.to_bits() => Some(Self(bits)),
            _ => None,
        }
    }

    #[inline]
    pub(crate) fn get(self) -> f64 {
        f64::from_bits(self.0)
    }

    /// The next larger f64, which may be infinite. By its bits: `f64::next_up` compares with zero.
    #[inline]
    pub(crate) fn next_up(self) -> f64 {
        f64::from_bits(self.0 + 1)
    }
}

impl fmt::Debug for NonNegative {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.get().fmt(f)
    }
}
