//! Polynomials between two times that are close to each other.

use alloc::vec::Vec;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::approximation::{Approximation, shifted};
use super::polynomial::Polynomial;
use super::split::Split;

/// A polynomial in τ as one in ρ, for τ = low + 2ʷ ρ with ρ in [0, 1].
///
/// Next to roots that are close to each other, times have many digits, and values are small differences of
/// large terms. Seen from one of these times, the others have few digits, and terms are as small as values.
#[derive(Clone, Debug)]
pub(super) struct Expansion {
    origin: Split,
    /// The exponent w of the width.
    width: isize,
    /// In units of 2ᵏ, with an error of less than 2ᵉ of them for all values.
    polynomial: Polynomial,
    pub(super) unit: isize,
    error: usize,
}

impl Expansion {
    /// The polynomial at a time between the two times of the expansion.
    pub(super) fn value_at(&self, t: &Split) -> Approximation {
        let time = t.after(&self.origin, self.width);
        let value = if time.is_end() {
            Approximation::exactly(self.polynomial.at_start())
        } else {
            self.polynomial
                .values(&time, &time, self.polynomial.precision_of(0, time.top()))
        };
        let own = self.error.saturating_add_signed(-value.unit);
        Approximation {
            middle: value.middle,
            unit: value.unit + self.unit,
            error: Some(value.error.unwrap_or_default().max(own) + 1),
        }
    }
}

impl Polynomial {
    /// The polynomial between two times of a [closeness](Split::closeness) c of at least 8, in the unit 2ᵏ.
    ///
    /// Let τ = 2ˢ σ with high ≤ 2ˢ. Horner's scheme divides by σ − low, which leaves the value there. The
    /// same for the quotient leaves the next coefficient, and so on. With σ = low + 2⁻ᶜ ρ, the coefficients
    /// of the i-th quotient are multiplied by 2⁻ᶜⁱ. If the n + 1 coefficients of σ are at most 2ᵇ, its sums
    /// are at most 2ⁿ⁺¹⁺ᵇ⁻ᶜⁱ, because the binomial coefficients in them are at most 2ⁿ⁺¹. So `low` is rounded
    /// down to two more bits than that, which adds at most 1 to the error of a sum, its own error included,
    /// and rounding the product adds at most 1. If the error of the coefficients of a quotient is at most 2,
    /// the error of its sums is at most 4 (n + 1) ≤ 2ᶜ, and the error of the next coefficients at most 2. A
    /// sum of n + 1 coefficients is off by at most 4 (n + 1)².
    pub(super) fn expansion(&self, low: &Split, high: &Split, unit: isize) -> Expansion {
        let closeness = Split::closeness(low, high);
        let scale = high.top();
        let bits = self.top_at(scale) - unit;
        let length = (scale - low.exponent).max(0).unsigned_abs();
        let coefficients = self.coefficients().iter().enumerate();
        let mut quotient: Vec<_> = coefficients
            .map(|(i, c)| shifted(c, i as isize * scale - unit))
            .collect();
        let margin = quotient.len() + 2;
        let mut expanded = Vec::with_capacity(quotient.len());
        while !quotient.is_empty() {
            let left = bits - (closeness * expanded.len()) as isize;
            let digits = length.min(left.max(0).unsigned_abs() + margin);
            let start = &low.elapsed >> (length - digits);
            let mut sum = IBig::ZERO;
            for coefficient in quotient.iter_mut().rev() {
                sum = ((sum * &start) >> digits) + &*coefficient;
                coefficient.clone_from(&sum);
            }
            quotient.remove(0);
            for coefficient in &mut quotient {
                *coefficient >>= closeness;
            }
            expanded.push(sum);
        }
        Expansion {
            origin: low.clone(),
            width: scale - closeness as isize,
            error: 2 * expanded.len().bit_len() + 2,
            polynomial: Self::new(expanded),
            unit,
        }
    }
}
