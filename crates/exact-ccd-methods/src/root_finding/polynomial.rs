//! Polynomials in time.

use std::ops::{Add, Mul, Neg, Sub};

/// The highest degree that occurs: the squared volume of four moving points has it.
pub(super) const MAX_DEGREE: usize = 6;

/// A polynomial of degree at most [`MAX_DEGREE`], rounded at every operation.
///
/// The operations are always inlined: then the degrees are constants where polynomials are made,
/// and the loops unroll.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Polynomial {
    /// The coefficients of tⁱ; zero beyond the degree.
    coefficients: [f64; MAX_DEGREE + 1],
    /// The degree by construction: the leading coefficient may be zero.
    degree: usize,
}

impl Polynomial {
    /// Σ cᵢ tⁱ.
    #[inline(always)]
    pub(super) fn new<const N: usize>(coefficients: [f64; N]) -> Self {
        Self::from_fn(N - 1, |i| coefficients[i])
    }

    #[inline(always)]
    pub(super) fn from_fn(degree: usize, coefficient: impl Fn(usize) -> f64) -> Self {
        let mut coefficients = [0.0; MAX_DEGREE + 1];
        for (i, c) in coefficients[..=degree].iter_mut().enumerate() {
            *c = coefficient(i);
        }
        Self { coefficients, degree }
    }

    pub(super) fn degree(&self) -> usize {
        self.degree
    }

    /// c₀ … cₙ for the degree n.
    #[inline(always)]
    pub(super) fn coefficients(&self) -> &[f64] {
        &self.coefficients[..=self.degree]
    }

    /// cᵢ, which is 0 beyond the degree, for i up to [`MAX_DEGREE`].
    pub(super) fn coefficient(&self, i: usize) -> f64 {
        self.coefficients[i]
    }

    /// The same polynomial without leading coefficients that are zero.
    pub(super) fn trimmed(self) -> Self {
        let degree = (0..=self.degree).rfind(|&i| self.coefficients[i] != 0.0);
        Self {
            degree: degree.unwrap_or(0),
            ..self
        }
    }

    /// The value at t, by Horner's rule.
    pub(super) fn at(&self, t: f64) -> f64 {
        let [lower @ .., leading] = self.coefficients() else {
            return 0.0;
        };
        lower.iter().rev().fold(*leading, |value, c| value * t + c)
    }
}

impl Add for Polynomial {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::from_fn(self.degree.max(other.degree), |i| {
            self.coefficients[i] + other.coefficients[i]
        })
    }
}

impl Neg for Polynomial {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self * -1.0
    }
}

impl Sub for Polynomial {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul<f64> for Polynomial {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        Self::from_fn(self.degree, |i| factor * self.coefficients[i])
    }
}

impl Mul for Polynomial {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let mut product = Self::from_fn(self.degree + other.degree, |_| 0.0);
        for (i, a) in self.coefficients().iter().enumerate() {
            for (j, b) in other.coefficients().iter().enumerate() {
                product.coefficients[i + j] += a * b;
            }
        }
        product
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_product_has_the_product_of_the_values() {
        let (a, b) = (
            Polynomial::new([1.0, -2.0, 3.0]),
            Polynomial::new([-4.0, 0.5, 0.0, 2.0]),
        );
        for t in [-2.0, 0.0, 0.5, 3.0] {
            assert_eq!((a * b).at(t), a.at(t) * b.at(t));
            assert_eq!((a - b).at(t), a.at(t) - b.at(t));
        }
    }

    #[test]
    fn only_leading_zeros_are_trimmed() {
        assert_eq!(
            Polynomial::new([0.0, 0.0, 3.0, 0.0]).trimmed().coefficients(),
            [0.0, 0.0, 3.0]
        );
        assert_eq!(Polynomial::new([0.0; 7]).trimmed().coefficients(), [0.0]);
    }
}
