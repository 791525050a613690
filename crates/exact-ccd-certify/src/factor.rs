//! Common factors of polynomials with integer coefficients.

use dashu_int::IBig;
use dashu_int::ops::Gcd;
use exact_ccd_check::polynomial::Polynomial;

/// The greatest common divisor of two polynomials, up to a factor. If one is 0, it is the other one.
pub(crate) fn gcd(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let (mut a, mut b) = (primitive(a.0.clone()), primitive(b.0.clone()));
    while !b.is_empty() {
        let rest = primitive(remainder(a, &b));
        a = b;
        b = rest;
    }
    Polynomial(a)
}

/// The derivative with respect to the ratio of the distances from both ends of the interval.
pub(crate) fn derivative(a: &Polynomial) -> Polynomial {
    Polynomial((0_u32..).zip(&a.0).skip(1).map(|(power, c)| c * power).collect())
}

/// The remainder of the division of a multiple of a by b, whose last coefficient is not 0.
fn remainder(mut a: Vec<IBig>, b: &[IBig]) -> Vec<IBig> {
    while a.len() >= b.len() {
        let top = a.pop().unwrap_or(IBig::ZERO);
        let shift = a.len() + 1 - b.len();
        for c in &mut a {
            *c *= &b[b.len() - 1];
        }
        for (c, factor) in a[shift..].iter_mut().zip(b) {
            *c -= &top * factor;
        }
    }
    a
}

/// The coefficients without zeros at the end, and without their common divisor.
fn primitive(mut coefficients: Vec<IBig>) -> Vec<IBig> {
    while coefficients.last().is_some_and(IBig::is_zero) {
        coefficients.pop();
    }
    coprime(coefficients)
}

/// The integers without their common divisor.
pub(crate) fn coprime(mut integers: Vec<IBig>) -> Vec<IBig> {
    let nonzero = integers.iter().filter(|x| !x.is_zero());
    if let Some(divisor) = nonzero.cloned().reduce(|a, b| IBig::from(a.gcd(b))) {
        // The divisor of a single integer may be negative; signs must stay.
        let divisor = if divisor < IBig::ZERO { -divisor } else { divisor };
        integers.iter_mut().for_each(|x| *x /= &divisor);
    }
    integers
}
