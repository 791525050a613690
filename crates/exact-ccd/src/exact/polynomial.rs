//! Univariate polynomials with integer coefficients.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use dashu_int::ops::{Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};

use super::dyadic::Dyadic;
use super::modular::are_coprime;

/// The coefficients from the constant one up; the last is not zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Polynomial(Vec<IBig>);

impl Polynomial {
    pub(crate) fn new(mut coefficients: Vec<IBig>) -> Self {
        while coefficients.last().is_some_and(IBig::is_zero) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    pub(crate) fn zero() -> Self {
        Self(Vec::new())
    }

    pub(crate) fn one() -> Self {
        Self(vec![IBig::ONE])
    }

    pub(crate) fn constant(value: u64) -> Self {
        Self::new(vec![value.into()])
    }

    /// The value at t = 0.
    pub(crate) fn constant_term(&self) -> IBig {
        self.0.first().cloned().unwrap_or_default()
    }

    /// The polynomial times 2ᵏ.
    pub(crate) fn shifted(&self, exponent: usize) -> Self {
        Self(self.0.iter().map(|coefficient| coefficient << exponent).collect())
    }

    /// t (1 − t): the ends of the step.
    pub(crate) fn ends() -> Self {
        Self(vec![IBig::ZERO, IBig::ONE, IBig::NEG_ONE])
    }

    /// The linear interpolant of a value at t = 0 and a value at t = 1.
    pub(crate) fn between(at_zero: &IBig, at_one: &IBig) -> Self {
        Self::new(vec![at_zero.clone(), at_one - at_zero])
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The sign of the value at t.
    pub(crate) fn sign_at(&self, t: &Dyadic) -> Ordering {
        self.scaled_value(&t.numerator, t.exponent).cmp(&IBig::ZERO)
    }

    /// The value at t = n / 2ᵏ, times 2ᵏ to the power of the degree.
    pub(super) fn scaled_value(&self, numerator: &IBig, exponent: usize) -> IBig {
        let mut sum = IBig::ZERO;
        for (power, coefficient) in self.0.iter().rev().enumerate() {
            sum = sum * numerator + (coefficient << (exponent * power));
        }
        sum
    }

    /// The quotient of the values of two polynomials at t, truncated to an integer, if it is in the
    /// range of u64.
    pub(crate) fn quotient_at(&self, divisor: &Self, t: &Dyadic) -> Option<u64> {
        let lifted = |p: &Self, other: &Self| {
            p.scaled_value(&t.numerator, t.exponent) << (t.exponent * other.0.len().saturating_sub(p.0.len()))
        };
        let (value, by) = (lifted(self, divisor), lifted(divisor, self));
        if by.is_zero() {
            return None;
        }
        u64::try_from(value / by).ok()
    }

    /// The sign in the whole interval (low, high), if Descartes' rule proves it: no
    /// [`sign_changes`](Self::sign_changes).
    pub(crate) fn sign_between(&self, low: &Dyadic, high: &Dyadic) -> Option<Ordering> {
        let (changes, sign) = self.sign_changes(low, high);
        (changes == 0).then_some(sign)
    }

    /// The number of sign changes in the coefficients of (1 + s)ᵈ q((low + high s) / (1 + s)), and
    /// the first sign that is not zero.
    ///
    /// By Descartes' rule, the number of roots of q in (low, high), counted with multiplicity, is
    /// the number of sign changes or less than that by an even number.
    pub(crate) fn sign_changes(&self, low: &Dyadic, high: &Dyadic) -> (usize, Ordering) {
        let ([low, high], exponent) = Dyadic::align(low, high);
        let from_unit = Self(vec![low.clone(), high - low]);
        let mut inner = self.compose(&from_unit, exponent);
        inner.resize(self.0.len(), IBig::ZERO);
        inner.reverse();
        let outer = Self(inner).compose(&Self(vec![IBig::ONE, IBig::ONE]), 0);
        let (mut first, mut last, mut changes) = (Ordering::Equal, Ordering::Equal, 0);
        for sign in outer
            .iter()
            .map(|c| c.cmp(&IBig::ZERO))
            .filter(|sign| sign.is_ne())
        {
            if first.is_eq() {
                first = sign;
            }
            changes += usize::from(last == sign.reverse());
            last = sign;
        }
        (changes, first)
    }

    /// The coefficients of 2ᵏᵈ q(inner / 2ᵏ), from the constant one up.
    fn compose(&self, inner: &Self, exponent: usize) -> Vec<IBig> {
        let mut sum = Self::zero();
        for (power, coefficient) in self.0.iter().rev().enumerate() {
            sum = &(&sum * inner) + &Self::new(vec![coefficient << (exponent * power)]);
        }
        sum.0
    }

    /// A polynomial with the same roots, all simple.
    pub(crate) fn square_free(&self) -> Self {
        let repeated = self.clone().gcd(self.derivative());
        self.quotient(&repeated)
    }

    pub(crate) fn derivative(&self) -> Self {
        Self(
            self.0
                .iter()
                .enumerate()
                .skip(1)
                .map(|(power, c)| c * IBig::from(power))
                .collect(),
        )
    }

    /// The polynomial divided by the greatest common divisor of its coefficients.
    pub(crate) fn primitive(mut self) -> Self {
        let mut content = UBig::ZERO;
        for coefficient in &self.0 {
            let magnitude = coefficient.clone().unsigned_abs();
            content = if content.is_zero() {
                magnitude
            } else {
                content.gcd(magnitude)
            };
            if content.is_one() {
                return self;
            }
        }
        let content = IBig::from(content);
        for coefficient in &mut self.0 {
            *coefficient /= &content;
        }
        self
    }

    /// Quotient and remainder of this polynomial times a positive integer: the smallest power of
    /// the magnitude of the divisor's leading coefficient for which all coefficients of the
    /// quotient are integers by construction.
    fn divide(&self, divisor: &Self) -> (Self, Self) {
        let Some(leading) = divisor.0.last() else {
            return (Self::zero(), self.clone());
        };
        let steps = (self.0.len() + 1).saturating_sub(divisor.0.len());
        let mut quotient = vec![IBig::ZERO; steps];
        let mut remainder = self.0.clone();
        // |leading| keeps the multiplier positive.
        let (magnitude, sign) = (IBig::from(leading.clone().unsigned_abs()), leading.signum());
        for step in (0..steps).rev() {
            let top = remainder.pop().unwrap_or_default() * &sign;
            for coefficient in remainder.iter_mut().chain(&mut quotient[step + 1..]) {
                *coefficient *= &magnitude;
            }
            for (target, coefficient) in remainder[step..].iter_mut().zip(&divisor.0) {
                *target -= &top * coefficient;
            }
            quotient[step] = top;
        }
        (Self::new(quotient), Self::new(remainder))
    }

    /// A positive multiple of the remainder of a division.
    pub(crate) fn remainder(&self, divisor: &Self) -> Self {
        self.divide(divisor).1.primitive()
    }

    /// A multiple of the quotient of a division that leaves no remainder.
    pub(crate) fn quotient(&self, divisor: &Self) -> Self {
        if divisor.0.len() == 1 {
            return self.clone();
        }
        self.divide(divisor).0.primitive()
    }

    /// A greatest common divisor; that of a polynomial and zero is the polynomial.
    pub(crate) fn gcd(self, other: Self) -> Self {
        if are_coprime(&self.0, &other.0) {
            return Self::one();
        }
        let (mut a, mut b) = (self, other);
        while !b.is_zero() {
            (a, b) = (b.clone(), a.remainder(&b));
        }
        a.primitive()
    }

    /// The polynomial without its root t = n / 2ᵏ, whatever the multiplicity.
    pub(crate) fn without_root(mut self, t: &Dyadic) -> Self {
        let root = Self(vec![-t.numerator.clone(), IBig::ONE << t.exponent]);
        while !self.is_zero() && self.sign_at(t).is_eq() {
            self = self.quotient(&root);
        }
        self
    }
}

impl Neg for Polynomial {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.into_iter().map(|coefficient| -coefficient).collect())
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;

    fn add(self, other: &Polynomial) -> Polynomial {
        let (long, short) = if self.0.len() < other.0.len() {
            (other, self)
        } else {
            (self, other)
        };
        let mut sum = long.0.clone();
        for (target, coefficient) in sum.iter_mut().zip(&short.0) {
            *target += coefficient;
        }
        Polynomial::new(sum)
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;

    fn sub(self, other: &Polynomial) -> Polynomial {
        self + &-other.clone()
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;

    fn mul(self, other: &Polynomial) -> Polynomial {
        if self.is_zero() || other.is_zero() {
            return Polynomial::zero();
        }
        let mut product = vec![IBig::ZERO; self.0.len() + other.0.len() - 1];
        for (i, a) in self.0.iter().enumerate() {
            for (target, b) in product[i..].iter_mut().zip(&other.0) {
                *target += a * b;
            }
        }
        Polynomial(product)
    }
}
