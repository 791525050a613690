//! Distances: the threshold of a query, and bounds of the distance at one time.

use core::cmp::Ordering;

/// A distance d below which two primitives count as close: a finite f64, at least 0, in the unit of
/// the coordinates.
///
/// It is taken exactly. −0.0 is 0.
#[derive(Clone, Copy, Debug, Default)]
pub struct Separation(f64);

/// A separation is negative, infinite or not a number.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("separation {value} is not a finite number of at least 0")]
pub struct InvalidSeparation {
    /// The separation.
    pub value: f64,
}

impl Separation {
    /// The separation d.
    ///
    /// # Errors
    /// [`InvalidSeparation`], if d is negative, infinite or not a number.
    pub fn new(d: f64) -> Result<Self, InvalidSeparation> {
        let magnitude = d.abs();
        // By its sign, because a comparison may read a subnormal number as zero.
        if d.is_finite() && (d.is_sign_positive() || magnitude.to_bits() == 0) {
            Ok(Self(magnitude))
        } else {
            Err(InvalidSeparation { value: d })
        }
    }

    /// The separation as an f64.
    #[must_use]
    #[inline]
    pub fn get(self) -> f64 {
        self.0
    }

    /// Returns true for 0. By its bits, because a comparison may read a subnormal number as zero.
    #[must_use]
    #[inline]
    pub fn is_zero(self) -> bool {
        self.0.to_bits() == 0
    }

    /// The least f64 that is not below the sum of two separations, which is at most the largest f64.
    ///
    /// In integers, which no floating-point environment changes. In units in the last place of the
    /// larger summand, the smaller one is rounded up, and the sum then has at most 54 bits; if it has
    /// more than 53, half of it is rounded up. Both roundings together are one: ⌈⌈x⌉ / 2⌉ = ⌈x / 2⌉.
    #[inline]
    pub(super) fn plus(self, other: Self) -> Self {
        const DIGITS: u32 = f64::MANTISSA_DIGITS - 1;
        let (a, b) = (self.0.to_bits(), other.0.to_bits());
        // A subnormal number has the unit of the smallest normal one.
        let exponent = |bits: u64| (bits >> DIGITS).max(1);
        let significand = |bits: u64| bits - ((exponent(bits) - 1) << DIGITS);
        let (small, large) = (a.min(b), a.max(b));
        let shift = (exponent(large) - exponent(small)).min(63);
        let sum = significand(large) + significand(small).div_ceil(1 << shift);
        let carry = u64::from(sum > 2 << DIGITS);
        let bits = ((exponent(large) - 1 + carry) << DIGITS) + sum.div_ceil(1 + carry);
        Self(f64::from_bits(bits))
    }
}

impl PartialEq for Separation {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Separation {}

impl PartialOrd for Separation {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// By their bits, which are in the order of numbers that are not negative: a comparison of subnormal
/// numbers may read them as zero.
impl Ord for Separation {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.to_bits().cmp(&other.0.to_bits())
    }
}

impl TryFrom<f64> for Separation {
    type Error = InvalidSeparation;

    fn try_from(d: f64) -> Result<Self, InvalidSeparation> {
        Self::new(d)
    }
}

/// The distance of two primitives at one time, between two f64.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceBounds {
    /// The largest f64 that is not above the distance.
    pub lower: f64,
    /// The smallest f64 that is not below the distance; infinite if the distance is above all of
    /// them.
    pub upper: f64,
}

/// A time is not in [0, 1].
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("time {time} is not in the step, from 0 to 1")]
pub struct TimeOutOfStep {
    /// The time.
    pub time: f64,
}

impl TimeOutOfStep {
    /// Checks that a time is in [0, 1]: by its bits, because a comparison may read a subnormal number as
    /// zero.
    pub(crate) fn check(time: f64) -> Result<(), Self> {
        let bits = time.to_bits();
        if bits <= 1.0_f64.to_bits() || bits == (-0.0_f64).to_bits() {
            Ok(())
        } else {
            Err(Self { time })
        }
    }
}
