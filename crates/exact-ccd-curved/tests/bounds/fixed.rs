//! Numbers with 700 binary places.

use dashu_int::IBig;

const PLACES: usize = 700;

/// A multiple of 2⁻⁷⁰⁰. Products are rounded down.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub(crate) struct Fixed(IBig);

impl From<f64> for Fixed {
    /// Exactly, unless the number has more places.
    fn from(x: f64) -> Self {
        let (mantissa, exponent) = decode(x);
        let shift = PLACES as i64 + exponent;
        let value = IBig::from(mantissa);
        Self(if shift >= 0 {
            value << shift as usize
        } else {
            value >> (-shift) as usize
        })
    }
}

/// The integer m and the exponent e of m 2ᵉ.
fn decode(x: f64) -> (i64, i64) {
    let bits = x.to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i64;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let (mantissa, exponent) = if exponent == 0 {
        (fraction, -1074)
    } else {
        (fraction | 1 << 52, exponent - 1075)
    };
    (if x.is_sign_negative() { -mantissa } else { mantissa }, exponent)
}

impl Fixed {
    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self(&self.0 + &other.0)
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self(&self.0 - &other.0)
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        Self((&self.0 * &other.0) >> PLACES)
    }

    pub(crate) fn over(&self, divisor: i64) -> Self {
        Self(&self.0 / IBig::from(divisor))
    }

    pub(crate) fn squared(&self) -> Self {
        self.times(self)
    }

    /// The number, larger by 2⁻⁵⁰⁰: above the error of all operations of a test.
    pub(crate) fn widened(&self) -> Self {
        Self(&self.0 + (IBig::ONE << 200))
    }

    /// The sine and the cosine, by their series for x / 2⁴⁰ and forty doublings of the angle, which
    /// magnify its error by less than 2⁸⁰.
    pub(crate) fn sine_and_cosine(&self) -> [Self; 2] {
        let small = Self(&self.0 >> 40);
        let square = small.squared();
        let one = Self::from(1.0);
        let series = |first: Self, parity: i64| {
            let (mut sum, mut term) = (first.clone(), first);
            for k in 1..60 {
                term = Self::from(0.0)
                    .minus(&term.times(&square))
                    .over((2 * k - 1 + parity) * (2 * k + parity));
                sum = sum.plus(&term);
            }
            sum
        };
        let (mut sine, mut cosine) = (series(small.clone(), 1), series(one.clone(), 0));
        for _ in 0..40 {
            let product = sine.times(&cosine);
            cosine = one.minus(&sine.squared().plus(&sine.squared()));
            sine = product.plus(&product);
        }
        [sine, cosine]
    }
}

impl Fixed {
    /// The number, to a few digits.
    pub(crate) fn to_f64(&self) -> f64 {
        let (sign, magnitude) = self.0.clone().into_parts();
        let length = dashu_int::ops::BitTest::bit_len(&magnitude);
        let shift = length.saturating_sub(60);
        let top = u64::try_from(magnitude >> shift).unwrap_or(u64::MAX) as f64;
        let value = top * 2.0_f64.powi(shift as i32 - PLACES as i32);
        if sign == dashu_int::Sign::Negative {
            -value
        } else {
            value
        }
    }
}
