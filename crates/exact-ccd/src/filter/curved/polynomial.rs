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

/// The binomial coefficient of n and k, below 2⁵³ and 0 for k > n: exact, as all products and quotients are
/// integers.
pub(super) fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| {
        product * n.saturating_sub(i) as f64 / (i + 1) as f64
    })
}

/// The polynomial with these control points.
pub(super) fn bezier<T: Coefficient>(control: Polynomial<T>) -> Polynomial<T> {
    let degree = control.len().saturating_sub(1);
    let terms = control.into_iter().enumerate();
    terms.map(|(k, x)| x * binomial(degree, k)).collect()
}

/// The control points of a polynomial in place of its coefficients.
pub(super) fn to_bernstein<T: Coefficient + Div<f64, Output = T>>(polynomial: &mut Polynomial<T>) {
    let degree = polynomial.len().saturating_sub(1);
    for (k, x) in polynomial.iter_mut().enumerate() {
        *x = *x / binomial(degree, k);
    }
}

pub(super) fn map<T: Coefficient>(polynomial: &Polynomial<T>, change: impl Fn(T) -> T) -> Polynomial<T> {
    polynomial.iter().map(|&x| change(x)).collect()
}

/// A polynomial with more coefficients, by factors t + s.
pub(super) fn elevate<T: Coefficient>(polynomial: &mut Polynomial<T>, count: usize) {
    while let Some(&last) = polynomial.last()
        && polynomial.len() < count
    {
        for k in (1..polynomial.len()).rev() {
            polynomial[k] = polynomial[k] + polynomial[k - 1];
        }
        polynomial.push(last);
    }
}

pub(super) fn sum<T: Coefficient>(a: &Polynomial<T>, b: &Polynomial<T>) -> Polynomial<T> {
    a.iter().zip(b).map(|(&a, &b)| a + b).collect()
}

pub(super) fn difference<T: Coefficient>(a: &Polynomial<T>, b: &Polynomial<T>) -> Polynomial<T> {
    a.iter().zip(b).map(|(&a, &b)| a - b).collect()
}

pub(super) fn product<T: Coefficient>(a: &Polynomial<T>, b: &Polynomial<T>) -> Polynomial<T> {
    let count = (a.len() + b.len()).saturating_sub(1);
    (0..count)
        .filter_map(|k| {
            let terms = (k.saturating_sub(b.len() - 1)..=k.min(a.len() - 1)).map(|i| a[i] * b[k - i]);
            terms.reduce(|sum, term| sum + term)
        })
        .collect()
}
