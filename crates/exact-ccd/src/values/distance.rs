//! Distances: the threshold of a query, and bounds of the distance at one time.

use core::fmt;

use super::non_negative::NonNegative;

/// A distance d: two primitives touch if they are at most d apart. It is a finite f64, at least 0, in the
/// unit of the coordinates.
///
/// It is taken exactly. −0.0 is 0. The default is 0, which is contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Separation(NonNegative);

/// A separation is negative, infinite or not a number.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("distance {value} is not a finite number of at least 0")]
pub struct InvalidSeparation {
    /// The separation.
    pub value: f64,
}

impl Separation {
    /// The separation 0: contact.
    pub const ZERO: Self = Self(NonNegative::ZERO);

    /// The separation d.
    ///
    /// # Errors
    /// [`InvalidSeparation`], if d is negative, infinite or not a number.
    pub fn new(d: f64) -> Result<Self, InvalidSeparation> {
        NonNegative::new(d)
            .map(Self)
            .ok_or(InvalidSeparation { value: d })
    }

    /// The separation as an f64.
    #[must_use]
    #[inline]
    pub fn get(self) -> f64 {
        self.0.get()
    }

    /// Returns true for 0.
    #[must_use]
    #[inline]
    pub fn is_zero(self) -> bool {
        self == Self::ZERO
    }

    /// The least f64 that is not below the sum of two separations, which is at most the largest f64.
    #[inline]
    pub(crate) fn plus(self, other: Self) -> Self {
        const DIGITS: u32 = f64::MANTISSA_DIGITS - 1;
        let bits = sum_rounded_up::<DIGITS>(self.get().to_bits(), other.get().to_bits());
        Self(NonNegative::new(f64::from_bits(bits)).expect("the sum is at most the largest f64"))
    }
}

/// The least number that is not below the sum of two numbers of at least 0, all by their bits, in a format
/// with this number of binary digits after the first one of a significand.
///
/// In integers, which no floating-point environment changes. In units in the last place of the larger
/// summand, the smaller one is rounded up, and the sum then has at most 54 bits of f64; if it has more than
/// 53, half of it is rounded up. Both roundings together are one: ⌈⌈x⌉ / 2⌉ = ⌈x / 2⌉.
#[inline]
fn sum_rounded_up<const DIGITS: u32>(a: u64, b: u64) -> u64 {
    // A subnormal number has the unit of the smallest normal one.
    let exponent = |bits: u64| (bits >> DIGITS).max(1);
    let significand = |bits: u64| bits - ((exponent(bits) - 1) << DIGITS);
    let (small, large) = (a.min(b), a.max(b));
    let shift = (exponent(large) - exponent(small)).min(63);
    let sum = significand(large) + significand(small).div_ceil(1 << shift);
    let carry = u64::from(sum > 2 << DIGITS);
    ((exponent(large) - 1 + carry) << DIGITS) + sum.div_ceil(1 + carry)
}

impl fmt::Display for Separation {
    /// Writes the number.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.get().fmt(f)
    }
}

impl From<Separation> for f64 {
    fn from(separation: Separation) -> Self {
        separation.get()
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
    /// Checks that a time is in [0, 1]; −0.0 is 0.
    ///
    /// # Errors
    /// The time, if it is outside or NaN.
    pub fn check(time: f64) -> Result<(), Self> {
        match NonNegative::new(time) {
            Some(checked) if checked.get() <= 1.0 => Ok(()),
            _ => Err(Self { time }),
        }
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::{Separation, sum_rounded_up};

    /// All sums of two numbers with two digits after the first one and exponents up to 99, in units of the
    /// least number.
    #[test]
    fn sums_are_rounded_up_for_all_numbers_of_three_digits() {
        const EXPONENTS: u64 = 100;
        let values: Vec<u128> = (0..(EXPONENTS + 3) << 2)
            .map(|bits| match bits >> 2 {
                0 => bits.into(),
                exponent => u128::from((bits & 3) + 4) << (exponent - 1),
            })
            .collect();
        for (a, &x) in values.iter().enumerate().take((EXPONENTS << 2) as usize) {
            let mut least = a;
            for (b, &y) in values.iter().enumerate().take(a + 1) {
                while values[least] < x + y {
                    least += 1;
                }
                assert_eq!(sum_rounded_up::<2>(a as u64, b as u64), least as u64, "{a} {b}");
            }
        }
    }

    #[test]
    fn a_sum_with_the_least_number_is_the_next_one() {
        let [zero, least, one] =
            [0.0, f64::from_bits(1), 1.0].map(|d| Separation::new(d).expect("a distance"));
        assert_eq!(one.plus(zero).get(), 1.0);
        assert_eq!(one.plus(least).get(), 1.0_f64.next_up());
    }
}
