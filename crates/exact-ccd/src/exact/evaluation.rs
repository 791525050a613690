//! Values and signs of polynomials at times in [0, 1], to as many bits as a sign needs.

use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::approximation::{Approximation, shifted};
use super::polynomial::Polynomial;
use super::split::Split;

/// The least precision, in bits: numbers of two machine words hold products.
pub(super) const LEAST_PRECISION: usize = 60;

impl Polynomial {
    /// The sign of the value at t.
    pub(crate) fn sign_at(&self, t: &Split) -> Ordering {
        self.value_at(t, 0).middle.cmp(&IBig::ZERO)
    }

    /// The polynomial in τ at t, known to k bits; at t = 1, the last coefficient.
    pub(super) fn value_at(&self, t: &Split, bits: usize) -> Approximation {
        self.value_from(LEAST_PRECISION + bits, t, bits)
    }

    /// The polynomial in τ at t with a known sign, in a unit of at most 2ᵏ unless it is a plain integer.
    pub(super) fn value_in(&self, t: &Split, unit: isize) -> Approximation {
        self.value_from(self.precision_of(unit, t.top()), t, 0)
    }

    /// The polynomial in τ at t, known to k bits. The precision doubles until the sign is known, and then
    /// grows by the missing bits. Once it reaches the length of the plain integer, the plain integer is
    /// computed.
    fn value_from(&self, mut precision: usize, t: &Split, bits: usize) -> Approximation {
        while t.is_inner_ratio() && precision < self.length_at(t) {
            let value = self.values(t, t, precision);
            if value.is_known_to(bits) {
                return value;
            }
            precision += if value.is_known_to(1) {
                value.missing(bits) + 2
            } else {
                precision
            };
        }
        self.plain_value(t)
    }

    /// The precision of values in the unit 2ᵏ, for times up to 2ˢ.
    pub(super) fn precision_of(&self, unit: isize, scale: isize) -> usize {
        let precision = self.top_at(scale).saturating_sub(unit);
        usize::try_from(precision)
            .unwrap_or_default()
            .max(LEAST_PRECISION)
    }

    /// The exponent of the least power of two above all terms, for times up to 2ˢ.
    pub(super) fn top_at(&self, scale: isize) -> isize {
        let terms = self.coefficients().iter().enumerate();
        let tops = terms
            .filter(|(_, c)| !c.is_zero())
            .map(|(i, c)| c.bit_len() as isize + i as isize * scale);
        tops.max().unwrap_or_default()
    }

    /// All values in [low, high] of the polynomial in τ at a precision of b bits, by Horner's scheme.
    ///
    /// Let τ = 2ˢ σ with high ≤ 2ˢ, hence σ in [0, 1], and let 2ᵏ be the unit in which the n + 1
    /// coefficients of σ are at most 2ᵇ. They and each product are rounded down to integers, σ at
    /// `low` down to b bits, so that it is off by at most δ 2⁻ᵇ, where δ ≤ 1 + 2ᵇ⁻ˢ (high − low). A sum
    /// of j coefficients is at most j 2ᵇ. So a step of Horner's scheme adds at most 2 + n δ to the
    /// error, and all of them at most (n + 1) (2 + n δ) ≤ (n + 1)² (1 + δ).
    pub(super) fn values(&self, low: &Split, high: &Split, precision: usize) -> Approximation {
        let scale = high.top();
        let unit = self.top_at(scale) - precision as isize;
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
        let [first, .., last] = self.coefficients() else {
            return Approximation::exactly(self.at_start());
        };
        if t.is_end() {
            return Approximation::exactly(if t.left.is_zero() { last } else { first }.clone());
        }
        let degree = self.coefficients().len() - 1;
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
