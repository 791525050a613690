//! Floating-point numbers that carry a bound of their error.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use super::number::{Number, Signed};

/// A number that differs from `value` by at most `error`.
///
/// This is a running error bound: it depends on the numbers that occur, where an a-priori bound
/// depends on the largest possible ones. An infinite or undefined bound means that the value is
/// unknown.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Bounded {
    value: f64,
    error: f64,
}

/// The rounding error of an operation relative to its result is at most ε/2; the other half pays
/// for the rounding of the bound itself, up to [`SLACK`].
const UNIT: f64 = f64::EPSILON;

/// A bound of the underflow error of a product and of its error bound.
const UNDERFLOW: f64 = f64::MIN_POSITIVE;

/// Covers some hundred operations; each rounds the bound down by a few ε at most.
const SLACK: f64 = 1.0 + 4096.0 * f64::EPSILON;

impl From<f64> for Bounded {
    #[inline]
    fn from(value: f64) -> Self {
        Self { value, error: 0.0 }
    }
}

impl Add for Bounded {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        Self {
            value,
            error: self.error + other.error + value.abs() * UNIT,
        }
    }
}

impl Neg for Bounded {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            error: self.error,
        }
    }
}

impl Sub for Bounded {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Bounded {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        let inherited =
            self.error * other.error + self.value.abs() * other.error + other.value.abs() * self.error;
        Self {
            value,
            error: inherited + value.abs() * UNIT + UNDERFLOW,
        }
    }
}

impl Number for Bounded {
    #[inline]
    fn times(self, n: u8) -> Self {
        let value = self.value * f64::from(n);
        Self {
            value,
            error: self.error * f64::from(n) + value.abs() * UNIT,
        }
    }
}

impl Signed for Bounded {
    /// `Equal` unless the bound rules out zero.
    #[inline]
    fn sign(&self) -> Option<Ordering> {
        let error = self.error * SLACK;
        Some(if self.value > error {
            Ordering::Greater
        } else if self.value < -error {
            Ordering::Less
        } else {
            Ordering::Equal
        })
    }
}
