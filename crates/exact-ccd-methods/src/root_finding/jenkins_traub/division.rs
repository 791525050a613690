//! Division by linear and quadratic polynomials.

use super::super::polynomial::{MAX_DEGREE, Polynomial};

/// z² + u z + v.
#[derive(Clone, Copy)]
pub(super) struct Quadratic {
    pub(super) u: f64,
    pub(super) v: f64,
}

/// P / (z − s) and P(s).
pub(super) fn divide_by_linear(p: &Polynomial, s: f64) -> (Polynomial, f64) {
    let mut quotient = [0.0; MAX_DEGREE + 1];
    let mut value = 0.0;
    for (i, c) in p.coefficients().iter().enumerate().rev() {
        quotient[i] = value;
        value = value * s + c;
    }
    (Polynomial::from_fn(p.degree() - 1, |i| quotient[i]), value)
}

/// b (z + u) + a, the remainder of a division by z² + u z + v.
#[derive(Clone, Copy)]
pub(super) struct Remainder {
    pub(super) a: f64,
    pub(super) b: f64,
}

/// P / σ and its remainder.
pub(super) fn divide(p: &Polynomial, sigma: Quadratic) -> (Polynomial, Remainder) {
    let mut quotient = [0.0; MAX_DEGREE + 1];
    let (mut a, mut b) = (0.0, 0.0);
    for (i, c) in p.coefficients().iter().enumerate().rev() {
        quotient[i] = b;
        (a, b) = (c - sigma.u * a - sigma.v * b, a);
    }
    (
        Polynomial::from_fn(p.degree() - 2, |i| quotient[i]),
        Remainder { a, b },
    )
}

/// The bound below which sums of terms of this size count as zero.
pub(super) fn negligible(size: f64) -> f64 {
    10.0 * f64::EPSILON * size.abs()
}
