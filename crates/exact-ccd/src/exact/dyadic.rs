//! Finite f64 as dyadic rationals m 2ᵉ, and sets of them as integers of one unit.

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::approximation::shifted;

/// (m, e) with x = m · 2ᵉ, for finite x; m is odd, or both are 0. Only the bit pattern is read.
pub(crate) fn decompose(x: f64) -> (i64, i32) {
    let (mantissa, exponent) = parts(x);
    if mantissa == 0 {
        return (0, 0);
    }
    let zeros = mantissa.trailing_zeros();
    (mantissa >> zeros, exponent + zeros as i32)
}

/// (m, e) with x = m · 2ᵉ, for finite x; m has at most 53 bits. Only the bit pattern is read.
#[inline(always)]
pub(crate) fn parts(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let biased = (bits >> 52 & 0x7ff) as i32;
    let leading = u64::from(biased > 0) << 52;
    let magnitude = (bits & ((1 << 52) - 1) | leading) as i64;
    let sign = bits as i64 >> 63;
    ((magnitude ^ sign) - sign, biased.max(1) - 1075)
}

/// The numbers as integers, all divided by one power of two, and its exponent; none if all are zero. Only bit
/// patterns are read.
pub(crate) fn to_integers<const N: usize>(numbers: [f64; N]) -> ([IBig; N], Option<i32>) {
    let unit = unit_of(numbers);
    (numbers.map(|x| in_unit(x, unit)), unit)
}

/// The exponent of the largest power of two of which all numbers are multiples; none if all are zero.
pub(super) fn unit_of(numbers: impl IntoIterator<Item = f64>) -> Option<i32> {
    let parts = numbers.into_iter().map(decompose);
    let units = parts.filter(|(mantissa, _)| *mantissa != 0);
    units.map(|part| part.1).min()
}

/// A number as an integer, divided by the power of two with this exponent, of which it is a multiple.
pub(super) fn in_unit(x: f64, unit: Option<i32>) -> IBig {
    match (decompose(x), unit) {
        ((0, _), _) | (_, None) => IBig::ZERO,
        ((mantissa, exponent), Some(unit)) => IBig::from(mantissa) << (exponent - unit) as usize,
    }
}

/// 54: where the integral part of a number has at least so many bits, the largest f64 not above the number is
/// not above its integral part either.
pub(super) const ENOUGH_BITS: isize = 54;

/// The bits of the largest f64 that is not above m 2ᵏ, for an integer m ≥ 0, and true if it is that number.
pub(super) fn rounded_down(m: &IBig, k: isize) -> (u64, bool) {
    const DIGITS: isize = f64::MANTISSA_DIGITS as isize;
    const LEAST: isize = -1074;
    const LARGEST: u64 = f64::MAX.to_bits();
    if m.is_zero() {
        return (0, true);
    }
    // The exponent of a unit in the last place. A number of j units above the least exponent has j in the
    // bits above those of its significand, to which the first bit of a normal significand adds 1.
    let unit = (k + m.bit_len() as isize - DIGITS).max(LEAST);
    let significand = shifted(m, k - unit);
    let is_equal = shifted(&significand, unit - k) == *m;
    let above = (unit - LEAST) as u64;
    let significand = u64::try_from(significand).unwrap_or(u64::MAX);
    let bits = above.min(1 << 11) << (DIGITS - 1);
    match bits.checked_add(significand) {
        Some(bits) if bits <= LARGEST => (bits, is_equal),
        _ => (LARGEST, false),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded_down_to_the_largest_one_at_most() {
        let largest = f64::MAX.to_bits();
        let ones = (IBig::ONE << 53) - IBig::ONE;
        assert_eq!(rounded_down(&ones, 971), (largest, true));
        for exponent in [1024, 1025, 3000, 5000] {
            assert_eq!(rounded_down(&IBig::ONE, exponent), (largest, false));
        }
        assert_eq!(rounded_down(&IBig::ONE, -1074), (1, true));
        assert_eq!(rounded_down(&IBig::ONE, -1075), (0, false));
    }
}
