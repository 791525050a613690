//! Greatest common divisors of polynomials.

use alloc::vec;
use alloc::vec::Vec;

use dashu_int::ops::{Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};

use super::modular::are_coprime;
use super::polynomial::Polynomial;
use super::split::Split;

impl Polynomial {
    /// A greatest common divisor; that of a polynomial and zero is the polynomial. Factors without a root in
    /// [0, 1] may be missing.
    ///
    /// Common roots at t = 0 and t = 1 are common zeros at the ends of the coefficients. The rest is
    /// Euclid's algorithm for polynomials in τ.
    pub(crate) fn gcd(self, other: Self) -> Self {
        if other.is_zero() {
            return self;
        }
        if self.is_zero() {
            return other;
        }
        let zeros = [self.end_zeros(), other.end_zeros()];
        let [start, end] = [0, 1].map(|end: usize| zeros[0][end].min(zeros[1][end]));
        let [a, b] = [&self, &other].map(|p| p.reduced().coefficients().to_vec());
        let inner = if are_coprime(&a, &b) {
            [IBig::ONE].into()
        } else {
            euclid(a, b, |_| false).unwrap_or_default()
        };
        let mut common = vec![IBig::ZERO; start];
        common.extend(inner);
        common.resize(common.len() + end, IBig::ZERO);
        Self::new(common)
    }

    /// This polynomial without factors t + s, which are 1, and without all factors that it has in common with
    /// another one, which has no root in [0, 1].
    pub(super) fn coprime_to(mut self, other: &Self) -> Self {
        while let Some(lowered) = self.lowered() {
            self = lowered;
        }
        while !self.is_zero() {
            let common = self.clone().gcd(other.clone());
            if common.degree() == 0 {
                break;
            }
            self = self.over(&common);
        }
        self
    }

    /// The quotient by a divisor of this polynomial, times an integer.
    pub(super) fn over(&self, divisor: &Self) -> Self {
        let [start, end] = divisor.end_zeros();
        let inner = |p: &Self| p.coefficients()[start..p.coefficients().len() - end].to_vec();
        Self::new(quotient(inner(self), &primitive(inner(divisor))))
    }

    /// A polynomial with the same roots, all simple, for a polynomial that is [reduced](Self::reduced).
    ///
    /// A grazing contact is at a root where the sign does not change: here it becomes one where it does.
    pub(super) fn square_free(&self) -> Self {
        let slope = self.slope();
        if are_coprime(self.coefficients(), slope.coefficients()) {
            return self.clone();
        }
        let whole = self.coefficients().to_vec();
        let repeated = euclid(whole.clone(), slope.coefficients().to_vec(), |_| false);
        Self::new(quotient(whole, &repeated.unwrap_or_default()))
    }

    /// A greatest common divisor for the roots in (low, high); `None` if there certainly are no common ones.
    ///
    /// Every remainder of Euclid's algorithm vanishes at common roots: none are in an interval in which one
    /// of them has one sign.
    pub(super) fn gcd_between(&self, other: &Self, low: &Split, high: &Split) -> Option<Self> {
        let [a, b] = [self, other].map(|p| p.reduced().coefficients().to_vec());
        if are_coprime(&a, &b) {
            return None;
        }
        let has_one_sign = |rest: &[IBig]| {
            let values = Self::new(rest.to_vec()).values_between(low, high);
            values.sign().is_some()
        };
        euclid(a, b, has_one_sign).map(Self::new)
    }
}

/// The quotient of a division without remainder by a polynomial whose coefficients have no common divisor.
/// The coefficients of the quotient are integers, by Gauss's lemma.
fn quotient(mut a: Vec<IBig>, divisor: &[IBig]) -> Vec<IBig> {
    let Some((leading, rest)) = divisor.split_last() else {
        return a;
    };
    let mut quotient = Vec::new();
    while a.len() > rest.len() {
        let factor = a.pop().unwrap_or_default() / leading;
        let shift = a.len() - rest.len();
        for (target, coefficient) in a[shift..].iter_mut().zip(rest) {
            *target -= &factor * coefficient;
        }
        quotient.push(factor);
    }
    quotient.reverse();
    quotient
}

/// The greatest common divisor of polynomials in τ that are not zero, without a common divisor of its
/// coefficients, by Euclid's algorithm; `None` if it ends because of a remainder.
fn euclid(a: Vec<IBig>, b: Vec<IBig>, ends: impl Fn(&[IBig]) -> bool) -> Option<Vec<IBig>> {
    let (mut a, mut b) = (primitive(a), primitive(b));
    while let Some((leading, others)) = b.split_last() {
        let rest = remainder(a, leading, others);
        if !rest.is_empty() && ends(&rest) {
            return None;
        }
        (a, b) = (b, primitive(rest));
    }
    Some(a)
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

/// The remainder of a division, times a number that is not zero. The leading coefficient of the divisor is
/// not zero, and neither is the last one of the result.
fn remainder(mut a: Vec<IBig>, leading: &IBig, rest: &[IBig]) -> Vec<IBig> {
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
    while a.pop_if(|leading| leading.is_zero()).is_some() {}
    a
}
