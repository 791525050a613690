//! Numbers that bound their own errors.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::numbers::number::Number;

/// A number in f64 or in twice the precision, computed from exact numbers by sums and products.
///
/// It is a sum of products of the inputs, each with at most `roundings` factors from 1 − u to 1 + u, and
/// `magnitude` is the sum of their magnitudes: the error is at most γₙ times the magnitude, n being the
/// number of roundings (`docs/filters.md`, "The model"). u is the unit roundoff, or
/// [`ROUNDOFF`](crate::numbers::double_double::ROUNDOFF) in twice the precision. The magnitude, in f64, has
/// no more roundings than the value, which the margin of n covers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Counted<N = f64> {
    pub(super) value: N,
    pub(super) magnitude: f64,
    pub(super) roundings: u32,
}

impl<N: Number<Real = f64>> Counted<N> {
    pub(super) fn exactly(value: f64) -> Self {
        Self {
            value: N::difference(value, 0.0),
            magnitude: value.abs(),
            roundings: 0,
        }
    }

    fn sum(self, other: Self, value: N) -> Self {
        Self {
            value,
            magnitude: self.magnitude + other.magnitude,
            roundings: self.roundings.max(other.roundings) + 1,
        }
    }
}

impl<N: Number<Real = f64>> Add for Counted<N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.sum(other, self.value + other.value)
    }
}

impl<N: Number<Real = f64>> Sub for Counted<N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.sum(other, self.value - other.value)
    }
}

impl<N: Number<Real = f64>> Mul for Counted<N> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            magnitude: self.magnitude * other.magnitude,
            roundings: self.roundings + other.roundings + 1,
        }
    }
}

impl<N: Neg<Output = N>> Neg for Counted<N> {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            ..self
        }
    }
}

impl<N: Mul<f64, Output = N>> Mul<f64> for Counted<N> {
    type Output = Self;

    /// A power of two does not round.
    fn mul(self, factor: f64) -> Self {
        let is_power = factor.to_bits() << 12 == 0;
        Self {
            value: self.value * factor,
            magnitude: self.magnitude * factor.abs(),
            roundings: self.roundings + u32::from(!is_power),
        }
    }
}

impl Div<f64> for Counted {
    type Output = Self;

    fn div(self, divisor: f64) -> Self {
        Self {
            value: self.value / divisor,
            magnitude: self.magnitude / divisor.abs(),
            roundings: self.roundings + 1,
        }
    }
}
