//! Polynomials in t with integer coefficients.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::{Gcd, UnsignedAbs};

use super::time::Time;

/// Σ cᵢ tⁱ, without leading zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial(Vec<IBig>);

impl Polynomial {
    /// The polynomial with these coefficients, the constant one first.
    pub fn new(mut coefficients: Vec<IBig>) -> Self {
        while coefficients.last() == Some(&IBig::ZERO) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    /// Returns true if all coefficients are 0.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns true if the degree is 0, or the polynomial is zero.
    pub fn is_constant(&self) -> bool {
        self.0.len() < 2
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        let coefficient = |p: &Self, i: usize| p.0.get(i).cloned().unwrap_or_default();
        let length = self.0.len().max(other.0.len());
        Self::new(
            (0..length)
                .map(|i| coefficient(self, i) + coefficient(other, i))
                .collect(),
        )
    }

    /// The difference.
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// The negative.
    pub fn negated(&self) -> Self {
        self.scaled(&IBig::NEG_ONE)
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Self {
        let mut product = vec![IBig::ZERO; self.0.len() + other.0.len()];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        Self::new(product)
    }

    /// The product with a number.
    pub fn scaled(&self, factor: &IBig) -> Self {
        Self::new(self.0.iter().map(|c| c * factor).collect())
    }

    /// The derivative.
    pub fn derivative(&self) -> Self {
        Self::new((1..self.0.len()).map(|i| &self.0[i] * i).collect())
    }

    /// The sign at n / 2ˢ, which is the sign of Σ cᵢ nⁱ 2^(s (degree − i)), by Horner's scheme.
    pub(super) fn sign_at(&self, t: &Time) -> Ordering {
        let mut value = IBig::ZERO;
        for (i, c) in self.0.iter().rev().enumerate() {
            value = value * t.numerator() + (c << (i * t.shift()));
        }
        value.cmp(&IBig::ZERO)
    }

    /// The quotient and the remainder of a division, both times a positive integer.
    pub fn divided_by(&self, divisor: &Self) -> (Self, Self) {
        let lead = divisor.0.last().expect("a divisor is not zero");
        let (factor, sign) = (IBig::from(lead.unsigned_abs()), lead.signum());
        let (mut quotient, mut rest) = (vec![IBig::ZERO; self.0.len()], self.clone());
        while rest.0.len() >= divisor.0.len() {
            // |lead| rest − sign(lead) top t^shift divisor has no term of this degree.
            let shift = rest.0.len() - divisor.0.len();
            let top = rest.0.last().expect("it is as long as the divisor") * &sign;
            let mut term = vec![IBig::ZERO; shift];
            term.extend(divisor.0.iter().map(|c| c * &top));
            let length = rest.0.len();
            rest = rest.scaled(&factor).minus(&Self::new(term));
            assert!(rest.0.len() < length, "a division lowers the degree");
            quotient.iter_mut().for_each(|c| *c *= &factor);
            quotient[shift] += top;
        }
        (Self::new(quotient), rest)
    }

    /// The polynomial over the greatest common divisor of its coefficients: the same signs, less digits.
    pub fn primitive(&self) -> Self {
        let coefficients = self.0.iter().filter(|c| **c != IBig::ZERO);
        let magnitudes = coefficients.map(|c| IBig::from(c.unsigned_abs()));
        let Some(content) = magnitudes.reduce(|a, b| a.gcd(b).into()) else {
            return self.clone();
        };
        Self::new(self.0.iter().map(|c| c / &content).collect())
    }

    /// A greatest common divisor of two polynomials: Euclid's algorithm.
    pub fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.clone(), other.clone());
        while !b.is_zero() {
            let rest = a.divided_by(&b).1.primitive();
            (a, b) = (b, rest);
        }
        a.primitive()
    }
}
