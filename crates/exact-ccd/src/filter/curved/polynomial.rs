//! Polynomials with coefficients in the numbers of the filters.

use core::ops::{Div, Mul, Neg};

use arrayvec::ArrayVec;

use crate::numbers::number::Ring;

/// The largest number of coefficients: degree 8.
pub(super) const MOST: usize = 9;

/// A number of the filters: an f64 with a count, or a symbol of a proof.
pub(super) trait Coefficient: Ring + Neg<Output = Self> + Mul<f64, Output = Self> {}

impl<T: Ring + Neg<Output = T> + Mul<f64, Output = T>> Coefficient for T {}

/// A polynomial.
pub(super) type Polynomial<T> = ArrayVec<T, MOST>;

/// The binomial coefficients of n, with zeros after them: below 2⁵³, and exact, as all products and quotients
/// are integers.
pub(super) fn binomials<const N: usize>(n: usize) -> [f64; N] {
    let mut next = 1.0;
    core::array::from_fn(|k| {
        let this = next;
        next = next * n.saturating_sub(k) as f64 / (k + 1) as f64;
        this
    })
}

/// The polynomial with these control points.
pub(super) fn bezier<T: Coefficient>(control: Polynomial<T>) -> Polynomial<T> {
    let weights: [f64; MOST] = binomials(control.len().saturating_sub(1));
    let terms = control.into_iter().zip(weights);
    terms.map(|(x, weight)| x * weight).collect()
}

/// The control points of a polynomial in place of its coefficients.
pub(super) fn to_bernstein<T: Coefficient + Div<f64, Output = T>>(polynomial: &mut Polynomial<T>) {
    let weights: [f64; MOST] = binomials(polynomial.len().saturating_sub(1));
    for (x, weight) in polynomial.iter_mut().zip(weights) {
        *x = *x / weight;
    }
}

/// A function of t: a polynomial, or a value at one time.
pub(super) trait Function: Clone {
    fn negated(&self) -> Self;
    fn doubled(&self) -> Self;
    fn sum(&self, other: &Self) -> Self;
    fn difference(&self, other: &Self) -> Self;
    fn product(&self, other: &Self) -> Self;

    /// The number of coefficients.
    fn count(&self) -> usize;

    /// Increases the number of coefficients, by factors t + s.
    fn elevate(&mut self, count: usize);
}

impl<T: Coefficient> Function for Polynomial<T> {
    fn negated(&self) -> Self {
        self.iter().map(|&x| -x).collect()
    }

    fn doubled(&self) -> Self {
        self.iter().map(|&x| x * 2.0).collect()
    }

    fn sum(&self, other: &Self) -> Self {
        self.iter().zip(other).map(|(&a, &b)| a + b).collect()
    }

    fn difference(&self, other: &Self) -> Self {
        self.iter().zip(other).map(|(&a, &b)| a - b).collect()
    }

    fn product(&self, other: &Self) -> Self {
        let count = (self.len() + other.len()).saturating_sub(1);
        (0..count)
            .filter_map(|k| {
                let indices = k.saturating_sub(other.len() - 1)..=k.min(self.len() - 1);
                let terms = indices.map(|i| self[i] * other[k - i]);
                terms.reduce(|sum, term| sum + term)
            })
            .collect()
    }

    fn count(&self) -> usize {
        self.len()
    }

    fn elevate(&mut self, count: usize) {
        while let Some(&last) = self.last()
            && self.len() < count
        {
            for k in (1..self.len()).rev() {
                self[k] = self[k] + self[k - 1];
            }
            self.push(last);
        }
    }
}
