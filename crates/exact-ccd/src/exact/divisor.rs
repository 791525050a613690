//! Greatest common divisors of polynomials.

use alloc::vec::Vec;

use dashu_int::ops::{Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};

use super::modular::are_coprime;
use super::polynomial::Polynomial;

impl Polynomial {
    /// A greatest common divisor; that of a polynomial and zero is the polynomial.
    ///
    /// Common roots at t = 1, where τ is infinite, are common zeros at the end of the coefficients. The
    /// rest is Euclid's algorithm for polynomials in τ.
    pub(crate) fn gcd(self, other: Self) -> Self {
        if other.is_zero() {
            return self;
        }
        if self.is_zero() {
            return other;
        }
        let (mut a, mut b) = (self.coefficients().to_vec(), other.coefficients().to_vec());
        let at_end = [&mut a, &mut b].map(|x| without_zeros_at_end(x)).into_iter().min();
        let mut common = if are_coprime(&a, &b) {
            [IBig::ONE].into()
        } else {
            (a, b) = (primitive(a), primitive(b));
            while !b.is_empty() {
                let rest = primitive(remainder(a, &b));
                (a, b) = (b, rest);
            }
            a
        };
        common.resize(common.len() + at_end.unwrap_or_default(), IBig::ZERO);
        Self::new(common)
    }
}

/// Removes the zeros at the end, and returns their number.
fn without_zeros_at_end(coefficients: &mut Vec<IBig>) -> usize {
    let length = coefficients.len();
    while coefficients.pop_if(|leading| leading.is_zero()).is_some() {}
    length - coefficients.len()
}

/// The coefficients divided by their greatest common divisor.
fn primitive(mut coefficients: Vec<IBig>) -> Vec<IBig> {
    let mut content = UBig::ZERO;
    for coefficient in &coefficients {
        let magnitude = coefficient.clone().unsigned_abs();
        content = if content.is_zero() {
            magnitude
        } else {
            content.gcd(magnitude)
        };
        if content.is_one() {
            return coefficients;
        }
    }
    let content = IBig::from(content);
    for coefficient in &mut coefficients {
        *coefficient /= &content;
    }
    coefficients
}

/// The remainder of a division, times a number that is not zero. The last coefficient of the divisor is
/// not zero, and neither is that of the result.
fn remainder(mut a: Vec<IBig>, divisor: &[IBig]) -> Vec<IBig> {
    let Some((leading, rest)) = divisor.split_last() else {
        return a;
    };
    while a.len() > rest.len() {
        let top = a.pop().unwrap_or_default();
        let shift = a.len() - rest.len();
        for coefficient in &mut a {
            *coefficient *= leading;
        }
        for (target, coefficient) in a[shift..].iter_mut().zip(rest) {
            *target -= &top * coefficient;
        }
    }
    without_zeros_at_end(&mut a);
    a
}
