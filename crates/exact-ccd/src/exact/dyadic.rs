//! Finite f64 as dyadic rationals m 2ᵉ, and sets of them as integers of one unit.

use dashu_int::IBig;

/// (m, e) with x = m · 2ᵉ, for finite x; m is odd or zero. Only the bit pattern is read.
pub(crate) fn decompose(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let (mantissa, exponent) = match (bits >> 52) & 0x7ff {
        0 => (fraction, -1074),
        biased => (fraction | 1 << 52, biased as i32 - 1075),
    };
    if mantissa == 0 {
        return (0, i32::MAX);
    }
    let zeros = mantissa.trailing_zeros();
    let magnitude = mantissa >> zeros;
    (
        if x.is_sign_negative() {
            -magnitude
        } else {
            magnitude
        },
        exponent + zeros as i32,
    )
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
