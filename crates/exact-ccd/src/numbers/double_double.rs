//! Numbers of twice the precision: unevaluated sums of two f64.
//!
//! The error-free transforms are by Dekker (A floating-point technique for extending the available
//! precision, 1971) and Knuth. The sum and the product are the fast ones, whose errors are bounded relative
//! to the magnitudes of the operands, not of the result: at most [`ROUNDOFF`] (|a| + |b|) and [`ROUNDOFF`]
//! |a b|. (Joldes, Muller, Popescu, Tight and rigorous error bounds for basic building blocks of
//! double-word arithmetic, 2017.) Products are split by multiplication and not by a fused multiply-add,
//! which is a slow library call on targets without the instruction.

use core::ops::{Add, Mul, Neg, Sub};

use super::number::Number;

/// 2⁻¹⁰⁰: an upper bound of the relative error of one operation, four times the least power of two that Gappa
/// proves (`proof/double_double_product.g`).
pub(crate) const ROUNDOFF: f64 = f64::from_bits((1023 - 100) << 52);

/// high + low, with |low| at most half a unit in the last place of `high`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct DoubleDouble {
    pub(crate) high: f64,
    pub(crate) low: f64,
}

impl DoubleDouble {
    /// a + b, exactly.
    pub(crate) fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let of_b = high - a;
        let low = (a - (high - of_b)) + (b - of_b);
        Self { high, low }
    }

    /// a b, exactly unless a part of it underflows.
    fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let ((a1, a2), (b1, b2)) = (split(a), split(b));
        let low = ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2;
        Self { high, low }
    }

    /// high + low, exactly, if `high` is a multiple of the unit in the last place of `low` (Boldo, Graillat,
    /// Muller, On the robustness of the 2Sum and Fast2Sum algorithms, 2017).
    ///
    /// After a product, |low| is far below |high|. So it is after a sum, unless the heads cancel. Then the
    /// smaller head is at least half of the other one, and their sum is exact and a multiple of the unit in
    /// the last place of the smaller head, or 0. The low parts are at most half of the units of their
    /// heads, so that their sum is at most 3/2 of that unit: its own unit in the last place divides it.
    fn normalized(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self {
            high: sum,
            low: low - (sum - high),
        }
    }
}

impl Number for DoubleDouble {
    type Real = f64;

    /// a − b, exactly.
    fn difference(a: f64, b: f64) -> Self {
        Self::sum(a, -b)
    }

    fn value(self) -> f64 {
        self.high
    }
}

/// Two halves of at most 26 bits each.
fn split(a: f64) -> (f64, f64) {
    const FACTOR: f64 = ((1u64 << 27) + 1) as f64;
    let scaled = FACTOR * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

impl Add for DoubleDouble {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let sum = Self::sum(self.high, other.high);
        Self::normalized(sum.high, sum.low + (self.low + other.low))
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        Self::normalized(
            product.high,
            product.low + (self.high * other.low + self.low * other.high),
        )
    }
}

impl Mul<f64> for DoubleDouble {
    type Output = Self;

    fn mul(self, other: f64) -> Self {
        let product = Self::product(self.high, other);
        Self::normalized(product.high, product.low + self.low * other)
    }
}

#[cfg(test)]
mod tests {
    use dashu_ratio::RBig;
    use dashu_ratio::ops::Abs;

    use super::*;

    #[test]
    fn operations_are_exact_up_to_their_error() {
        let mut random = fastrand::Rng::with_seed(1);
        let rational = |x: f64| RBig::try_from(x).expect("a finite number");
        let exact = |x: DoubleDouble| rational(x.high) + rational(x.low);
        for _ in 0..1000 {
            let mut number = || {
                let low = libm::ldexp(random.f64() - 0.5, -random.i32(0..80));
                DoubleDouble::sum(random.f64() - 0.5, low)
            };
            let (a, b, c) = (number(), number(), number().high);
            let (x, y, z) = (exact(a), exact(b), rational(c));
            let sum = x.clone().abs() + y.clone().abs();
            for (found, expected, most) in [
                (a + b, &x + &y, sum.clone()),
                (a - b, &x - &y, sum),
                (a * b, &x * &y, (&x * &y).abs()),
                (a * c, &x * &z, (&x * &z).abs()),
            ] {
                let error = (exact(found) - expected).abs();
                assert!(error <= rational(ROUNDOFF) * most, "{a:?} {b:?} {c}");
            }
        }
    }
}
