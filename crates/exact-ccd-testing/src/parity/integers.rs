//! f64 as integers.

use dashu_int::IBig;

/// x in units of 2⁻¹⁰⁷⁴: every finite f64 is a multiple of this unit.
pub fn exactly(x: f64) -> IBig {
    assert!(x.is_finite());
    let bits = x.to_bits();
    let fraction = IBig::from(bits & ((1 << 52) - 1));
    let magnitude = match (bits >> 52) & 0x7ff {
        0 => fraction,
        biased => (fraction + (IBig::ONE << 52)) << (biased - 1) as usize,
    };
    if x < 0.0 { -magnitude } else { magnitude }
}

/// Numbers as integers in one unit, the largest possible power of two.
pub fn in_one_unit<const N: usize>(numbers: [f64; N]) -> [IBig; N] {
    let integers = numbers.map(exactly);
    let zeros = integers
        .iter()
        .filter_map(IBig::trailing_zeros)
        .min()
        .unwrap_or(0);
    integers.map(|n| n >> zeros)
}
