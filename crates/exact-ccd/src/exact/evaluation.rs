//! Values and signs of polynomials at times in [0, 1], to as many bits as a sign needs.

use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::approximation::{Approximation, shifted};
use super::polynomial::Polynomial;
use super::split::Split;

/// The least precision, in bits: numbers of two machine words hold products.
const LEAST_PRECISION: usize = 60;

impl Polynomial {
    /// The sign of the value at t.
    pub(crate) fn sign_at(&self, t: &Split) -> Ordering {
        self.value_at(t, 0).middle.cmp(&IBig::ZERO)
    }

    /// The polynomial in τ at t, known to k bits; at t = 1, the last coefficient.
    ///
    /// The precision is doubled until it suffices. It is at most that of the plain integer.
    pub(super) fn value_at(&self, t: &Split, bits: usize) -> Approximation {
        let mut precision = LEAST_PRECISION + bits;
        while t.is_inner_ratio() && precision < self.length_at(t) {
            let value = self.values(t, t, precision);
            if value.is_known_to(bits) {
                return value;
            }
            precision *= 2;
        }
        self.plain_value(t)
    }

    /// The sign of all values in [low, high], low < high, if it is one that is easily proved: by the signs
    /// of the coefficients, or by approximations of all values, the last of which takes the slope in the
    /// interval into account.
    ///
    /// Around a number at which the polynomial does not vanish, all values in a narrow bracket have a
    /// sign: the error of each approximation is then proportional to the width.
    pub(crate) fn sign_between(&self, low: &Split, high: &Split) -> Option<Ordering> {
        let closeness = Split::closeness(low, high);
        if closeness == 0 {
            return self.sign_everywhere();
        }
        let mut precision = LEAST_PRECISION;
        while precision < closeness {
            if let Some(sign) = self.values(low, high, precision).sign() {
                return Some(sign);
            }
            precision *= 2;
        }
        self.near(low, high, closeness).sign()
    }

    /// All values in [low, high] of the polynomial in τ: that at `low`, and the product of the largest
    /// magnitude of the slope and of the width as its error.
    fn near(&self, low: &Split, high: &Split, closeness: usize) -> Approximation {
        let value = self.values(low, low, LEAST_PRECISION + 2 * closeness);
        let slope = self.slope().values(low, high, LEAST_PRECISION + closeness);
        let change = slope.bound() + high.top() - closeness as isize - value.unit;
        Approximation {
            error: value
                .error
                .map(|error| error.max(change.max(0).unsigned_abs()) + 1),
            ..value
        }
    }

    /// The sign of all values in [0, 1], if all coefficients have it or are zero, the first and the last
    /// not.
    fn sign_everywhere(&self) -> Option<Ordering> {
        let sign = |c: &IBig| c.cmp(&IBig::ZERO);
        let [first, .., last] = self.coefficients() else {
            return self.coefficients().first().map(sign);
        };
        let at_start = sign(first);
        let agrees = |c: &IBig| sign(c) != at_start.reverse();
        (at_start.is_ne() && sign(last) == at_start && self.coefficients().iter().all(agrees))
            .then_some(at_start)
    }

    /// All values in [low, high] of the polynomial in τ at a precision of b bits, by Horner's scheme.
    ///
    /// Let τ = 2ˢ σ with high ≤ 2ˢ, hence σ in [0, 1], and let 2ᵏ be the unit in which the n + 1
    /// coefficients of σ are at most 2ᵇ. They and each product are rounded down to integers, σ at
    /// `low` down to b bits, so that it is off by at most δ 2⁻ᵇ, where δ ≤ 1 + 2ᵇ⁻ˢ (high − low). A sum
    /// of j coefficients is at most j 2ᵇ. So a step of Horner's scheme adds at most 2 + n δ to the
    /// error, and all of them at most (n + 1) (2 + n δ) ≤ (n + 1)² (1 + δ).
    fn values(&self, low: &Split, high: &Split, precision: usize) -> Approximation {
        let scale = high.top();
        let tops = self.coefficients().iter().enumerate();
        let tops = tops
            .filter(|(_, c)| !c.is_zero())
            .map(|(i, c)| c.bit_len() as isize + i as isize * scale);
        let unit = tops.max().unwrap_or_default() - precision as isize;
        let length = (scale - low.exponent).max(0).unsigned_abs();
        let digits = length.min(precision);
        let start = &low.elapsed >> (length - digits);
        let mut middle = IBig::ZERO;
        for (i, coefficient) in self.coefficients().iter().enumerate().rev() {
            middle = ((middle * &start) >> digits) + shifted(coefficient, i as isize * scale - unit);
        }
        let spread = if core::ptr::eq(low, high) {
            0
        } else {
            precision.saturating_sub(Split::closeness(low, high))
        };
        Approximation {
            middle,
            unit,
            error: Some(2 * self.coefficients().len().bit_len() + spread + 2),
        }
    }

    /// Σ cᵢ aⁱ bⁿ⁻ⁱ 2ᵏⁱ in integers, for the ratio a 2ᵏ : b.
    fn plain_value(&self, t: &Split) -> Approximation {
        let degree = self.coefficients().len().saturating_sub(1);
        let mut middle = IBig::ZERO;
        let mut left = IBig::ONE;
        for (power, coefficient) in self.coefficients().iter().enumerate().rev() {
            // For a negative k, all is multiplied by 2⁻ᵏⁿ.
            let halvings = if t.exponent < 0 { degree - power } else { power };
            middle = middle * &t.elapsed + ((coefficient * &left) << (t.exponent.unsigned_abs() * halvings));
            left *= &t.left;
        }
        Approximation {
            middle,
            unit: t.exponent.min(0) * degree as isize,
            error: None,
        }
    }

    /// A bound of the length of that integer for b = 1.
    fn length_at(&self, t: &Split) -> usize {
        let lengths = self.coefficients().iter().map(BitTest::bit_len);
        let digits = t.exponent.unsigned_abs() + t.elapsed.bit_len();
        lengths.max().unwrap_or_default() + self.coefficients().len() * digits
    }
}

#[cfg(test)]
mod tests;
