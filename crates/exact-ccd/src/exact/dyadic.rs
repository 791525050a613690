//! Finite f64 as dyadic rationals m 2ᵉ, and sets of them as integers of one unit.

use dashu_int::IBig;

/// (m, e) with x = m · 2ᵉ, for finite x; m is odd or zero. Only the bit pattern is read.
pub(crate) fn decompose(x: f64) -> (i64, i32) {
    let (mantissa, exponent) = parts(x);
    if mantissa == 0 {
        return (0, i32::MAX);
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
    let parts = numbers.map(decompose);
    let units = parts.iter().filter(|(mantissa, _)| *mantissa != 0);
    let unit = units.map(|part| part.1).min();
    let integer = |(mantissa, exponent): (i64, i32)| match (mantissa, unit) {
        (0, _) | (_, None) => IBig::ZERO,
        (_, Some(unit)) => IBig::from(mantissa) << (exponent - unit) as usize,
    };
    (parts.map(integer), unit)
}
