//! Zeros, and factors of a polynomial with known zeros.

use arrayvec::ArrayVec;

use super::super::polynomial::Polynomial;

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) struct Zero {
    pub(in super::super) re: f64,
    pub(in super::super) im: f64,
}

impl Zero {
    pub(super) fn real(re: f64) -> Self {
        Self { re, im: 0.0 }
    }
}

/// Zeros that have been found, and the polynomial without them.
pub(super) struct Factor {
    pub(super) zeros: ArrayVec<Zero, 2>,
    pub(super) quotient: Polynomial,
}

impl Factor {
    pub(super) fn linear(zero: f64, quotient: Polynomial) -> Self {
        Self {
            zeros: [Zero::real(zero)].into_iter().collect(),
            quotient,
        }
    }
}

/// The zeros of a z² + b z + c. Of two real ones, the smaller comes first.
pub(super) fn quadratic_zeros(a: f64, b: f64, c: f64) -> [Zero; 2] {
    let half = b / 2.0;
    let discriminant = half * half - a * c;
    let root = discriminant.abs().sqrt();
    if discriminant < 0.0 {
        let (re, im) = (-half / a, root / a);
        return [Zero { re, im }, Zero { re, im: -im }];
    }
    let sum = -(half + root.copysign(half));
    // Both vanish only together.
    let smaller = if sum == 0.0 { 0.0 } else { c / sum };
    [Zero::real(smaller), Zero::real(sum / a)]
}
