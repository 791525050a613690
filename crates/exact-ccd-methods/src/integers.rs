//! Points as integers.

use dashu_base::FloatEncoding;
use dashu_int::IBig;
use exact_ccd::Point;

/// All coordinates, divided by the same power of two.
pub(crate) fn to_integers<const N: usize, const M: usize>(points: &[[Point; N]; M]) -> [[[IBig; 3]; N]; M] {
    let parts = points.map(|points| points.map(|point| point.map(odd_mantissa)));
    let unit = parts
        .as_flattened()
        .as_flattened()
        .iter()
        .filter(|(mantissa, _)| *mantissa != 0)
        .map(|(_, exponent)| *exponent)
        .min()
        .unwrap_or_default();
    let integer =
        |(mantissa, exponent): (i64, i32)| IBig::from(mantissa) << (exponent - unit).max(0) as usize;
    parts.map(|points| points.map(|point| point.map(integer)))
}

/// m and e with x = m 2ᵉ and m odd, or both zero.
fn odd_mantissa(x: f64) -> (i64, i32) {
    let (mantissa, exponent) = x.decode().unwrap_or_default();
    match mantissa {
        0 => (0, 0),
        _ => {
            let zeros = mantissa.trailing_zeros();
            (mantissa >> zeros, i32::from(exponent) + zeros as i32)
        }
    }
}
