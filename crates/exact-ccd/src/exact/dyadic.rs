//! Dyadic rationals n / 2ᵏ: every finite f64 is one, and so is the mean of two.

use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

/// The non-negative number n / 2ᵏ in lowest terms: k = 0 or n odd.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Dyadic {
    pub(super) numerator: IBig,
    pub(super) exponent: usize,
}

impl Dyadic {
    pub(crate) const ZERO: Self = Self {
        numerator: IBig::ZERO,
        exponent: 0,
    };
    pub(crate) const ONE: Self = Self {
        numerator: IBig::ONE,
        exponent: 0,
    };

    fn new(numerator: IBig, exponent: usize) -> Self {
        let common = numerator.trailing_zeros().unwrap_or(exponent).min(exponent);
        Self {
            numerator: numerator >> common,
            exponent: exponent - common,
        }
    }

    fn power_of_half(exponent: usize) -> Self {
        Self {
            numerator: IBig::ONE,
            exponent,
        }
    }

    /// The value of `t`, which must lie in [0, 1].
    pub(crate) fn from_unit(t: f64) -> Self {
        let (mantissa, exponent) = decompose(t);
        // A number in [0, 1] has no bit above 2⁰: a positive exponent is that of zero.
        Self::new(mantissa.into(), exponent.min(0).unsigned_abs() as usize)
    }

    /// A number strictly between `low` < `high`. It bisects their logarithms while these are far
    /// apart, and the numbers then, so that a root near 0 takes as few bisections as any other.
    pub(crate) fn between(low: &Self, high: &Self) -> Self {
        let (below, above) = (low.magnitude(), high.magnitude());
        match below {
            None => Self::power_of_half(2 * above.unwrap_or(0) + 1),
            Some(below) if below > above.unwrap_or(0) + 1 => {
                Self::power_of_half((below + above.unwrap_or(0)) / 2)
            }
            Some(_) => {
                let ([low, high], exponent) = Self::align(low, high);
                Self::new(low + high, exponent + 1)
            }
        }
    }

    /// The numerators of two numbers over their larger denominator 2ᵏ, and k.
    pub(super) fn align(a: &Self, b: &Self) -> ([IBig; 2], usize) {
        let exponent = a.exponent.max(b.exponent);
        let scaled = |x: &Self| &x.numerator << (exponent - x.exponent);
        ([scaled(a), scaled(b)], exponent)
    }

    /// a − b for b ≤ a.
    pub(super) fn difference(a: &Self, b: &Self) -> Self {
        let ([a, b], exponent) = Self::align(a, b);
        Self::new(a - b, exponent)
    }

    /// This number divided by 2ᵏ.
    pub(super) fn halved(self, times: usize) -> Self {
        Self::new(self.numerator, self.exponent + times)
    }

    /// low + (high − low) index / 2ᵇ.
    pub(super) fn on_grid(low: &Self, high: &Self, index: &IBig, bits: usize) -> Self {
        let ([low, high], exponent) = Self::align(low, high);
        Self::new((&low << bits) + (high - low) * index, exponent + bits)
    }

    /// The k with 2⁻ᵏ ≤ x < 2¹⁻ᵏ for a number in (0, 1], `None` for 0.
    fn magnitude(&self) -> Option<usize> {
        (!self.numerator.is_zero()).then(|| self.exponent + 1 - self.numerator.bit_len())
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Self) -> Ordering {
        let ([this, other], _) = Self::align(self, other);
        this.cmp(&other)
    }
}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

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

/// The numbers as integers, all divided by one power of two, and its exponent. Only bit patterns
/// are read.
pub(crate) fn to_integers<const N: usize>(numbers: [f64; N]) -> ([IBig; N], i32) {
    let parts = numbers.map(decompose);
    let unit = parts.iter().map(|part| part.1).min().unwrap_or(i32::MAX);
    let integer = |(mantissa, exponent): (i64, i32)| match mantissa {
        0 => IBig::ZERO,
        _ => IBig::from(mantissa) << (exponent - unit) as usize,
    };
    // If all of them are zero, the unit is arbitrary.
    (parts.map(integer), if unit == i32::MAX { 0 } else { unit })
}
