//! Polynomials in t with integer coefficients, written symmetrically in both ends of the step.

use alloc::vec;
use alloc::vec::Vec;
use core::ops::{Add, Mul, Neg, Sub};

use dashu_int::IBig;

/// Σ cᵢ tⁱ sⁿ⁻ⁱ with s = 1 − t, for the degree n: the sum of degree n of the Bernstein polynomials, without
/// their binomial factors. Only polynomials of one degree are added.
///
/// The linear interpolant of two values has these as coefficients. With the ratio τ = t / u, the polynomial
/// is sⁿ Σ cᵢ τⁱ: in the inside of the step, it has the sign and the roots of a polynomial in τ > 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Polynomial(Vec<IBig>);

impl Polynomial {
    pub(crate) fn new(coefficients: Vec<IBig>) -> Self {
        Self(coefficients)
    }

    pub(crate) fn constant(value: IBig) -> Self {
        Self(vec![value])
    }

    /// t (1 − t): the ends of the step.
    pub(crate) fn ends() -> Self {
        Self(vec![IBig::ZERO, IBig::ONE, IBig::ZERO])
    }

    /// The linear interpolant of a value at t = 0 and a value at t = 1.
    pub(crate) fn between(at_zero: &IBig, at_one: &IBig) -> Self {
        Self(vec![at_zero.clone(), at_one.clone()])
    }

    /// The Bézier polynomial of these control values.
    pub(super) fn bezier(mut control: Vec<IBig>) -> Self {
        let degree = control.len().saturating_sub(1);
        let mut binomial = 1;
        for (i, value) in control.iter_mut().enumerate().take(degree).skip(1) {
            binomial = binomial * (degree - i + 1) / i;
            *value *= IBig::from(binomial);
        }
        Self(control)
    }

    /// The degree as it is written, with zeros.
    pub(super) fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    /// The same polynomial in a higher degree: times (t + s)ᵏ.
    pub(super) fn elevated(self, by: usize) -> Self {
        let mut coefficients = self.0;
        for _ in 0..by {
            let last = coefficients.last().cloned();
            for i in (1..coefficients.len()).rev() {
                let (before, rest) = coefficients.split_at_mut(i);
                rest[0] += &before[i - 1];
            }
            coefficients.extend(last);
        }
        Self(coefficients)
    }

    /// The same polynomial in the next lower degree, if it has one.
    pub(super) fn lowered(&self) -> Option<Self> {
        without_one(&self.0).map(Self)
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.iter().all(IBig::is_zero)
    }

    /// The coefficients c₀ … cₙ: the first is the value at t = 0, the last the value at t = 1.
    pub(super) fn coefficients(&self) -> &[IBig] {
        &self.0
    }

    /// The value at t = 0.
    pub(crate) fn at_start(&self) -> IBig {
        self.0.first().cloned().unwrap_or_default()
    }

    /// The value at t = 1.
    pub(crate) fn at_end(&self) -> IBig {
        self.0.last().cloned().unwrap_or_default()
    }

    /// The polynomial times 2ᵏ.
    pub(crate) fn shifted(&self, exponent: usize) -> Self {
        Self(self.0.iter().map(|coefficient| coefficient << exponent).collect())
    }

    /// The polynomial without its roots at t = 0 and t = 1, whatever their multiplicity, and in the least
    /// degree: without factors t + s, which are 1.
    pub(super) fn reduced(&self) -> Self {
        let [start, end] = self.end_zeros();
        let mut reduced = self.0[start..self.0.len() - end].to_vec();
        while let Some(quotient) = without_one(&reduced) {
            reduced = quotient;
        }
        Self(reduced)
    }

    /// The numbers of zeros at both ends of the coefficients, which are factors t and s, of a polynomial that
    /// is not zero.
    pub(super) fn end_zeros(&self) -> [usize; 2] {
        let is_inner = |c: &IBig| !c.is_zero();
        [
            self.0.iter().position(is_inner),
            self.0.iter().rev().position(is_inner),
        ]
        .map(Option::unwrap_or_default)
    }

    /// The square: products of different coefficients are computed once.
    pub(super) fn squared(&self) -> Self {
        let mut square = vec![IBig::ZERO; (2 * self.0.len()).saturating_sub(1)];
        for (i, a) in self.0.iter().enumerate() {
            square[2 * i] += a.sqr();
            let doubled = a << 1;
            for (target, b) in square[2 * i + 1..].iter_mut().zip(&self.0[i + 1..]) {
                *target += &doubled * b;
            }
        }
        Self(square)
    }

    /// The derivative by t. That of a constant is the constant 0.
    pub(crate) fn velocity(&self) -> Self {
        let degree = self.0.len().saturating_sub(1);
        if degree == 0 {
            return Self::constant(IBig::ZERO);
        }
        let pairs = self.0.windows(2).enumerate();
        Self(
            pairs
                .map(|(i, pair)| &pair[1] * IBig::from(i + 1) - &pair[0] * IBig::from(degree - i))
                .collect(),
        )
    }

    /// The derivative of the polynomial in τ.
    pub(super) fn slope(&self) -> Self {
        let powers = self.0.iter().enumerate().skip(1);
        Self(powers.map(|(power, c)| c * IBig::from(power)).collect())
    }
}

/// The quotient by t + s, if it leaves no remainder: cᵢ = qᵢ + qᵢ₋₁.
fn without_one(coefficients: &[IBig]) -> Option<Vec<IBig>> {
    let (last, others) = coefficients.split_last()?;
    let mut quotient = Vec::with_capacity(others.len());
    let mut previous = IBig::ZERO;
    for coefficient in others {
        previous = coefficient - previous;
        quotient.push(previous.clone());
    }
    (!others.is_empty() && previous == *last).then_some(quotient)
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
        debug_assert_eq!(self.0.len(), other.0.len(), "polynomials of one degree are added");
        Polynomial(self.0.iter().zip(&other.0).map(|(a, b)| a + b).collect())
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;

    fn sub(self, other: &Polynomial) -> Polynomial {
        debug_assert_eq!(
            self.0.len(),
            other.0.len(),
            "polynomials of one degree are subtracted"
        );
        Polynomial(self.0.iter().zip(&other.0).map(|(a, b)| a - b).collect())
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;

    fn mul(self, other: &Polynomial) -> Polynomial {
        let mut product = vec![IBig::ZERO; (self.0.len() + other.0.len()).saturating_sub(1)];
        for (i, a) in self.0.iter().enumerate() {
            for (target, b) in product[i..].iter_mut().zip(&other.0) {
                *target += a * b;
            }
        }
        Polynomial(product)
    }
}

/// A vector whose components are polynomials.
pub(crate) type Vector = [Polynomial; 3];

pub(super) fn cross_component(a: &Vector, b: &Vector, axis: usize) -> Polynomial {
    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
    &(&a[next] * &b[last]) - &(&a[last] * &b[next])
}

pub(crate) fn cross(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|axis| cross_component(a, b, axis))
}

pub(crate) fn dot(a: &Vector, b: &Vector) -> Polynomial {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

/// v · v.
pub(super) fn squared_length(v: &Vector) -> Polynomial {
    let [x, y, z] = v;
    &(&x.squared() + &y.squared()) + &z.squared()
}
