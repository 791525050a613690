//! Numbers that count their roundings, as `filter/proof` of the kernel does.

use std::ops::{Add, Mul, Sub};

/// A sum of products of exact numbers, the sum of the magnitudes of its terms, and the largest number of
/// roundings of a term.
#[derive(Clone, Copy, Debug)]
pub(super) struct Counted {
    pub(super) value: f64,
    magnitude: f64,
    roundings: u32,
}

impl Counted {
    pub(super) fn exactly(value: f64) -> Self {
        Self {
            value,
            magnitude: value.abs(),
            roundings: 0,
        }
    }

    /// n u times the magnitude. The factor covers the terms in u².
    pub(super) fn error(self) -> f64 {
        f64::from(self.roundings) * 0.5 * f64::EPSILON * self.magnitude * (1.0 + 1e-12)
    }

    fn sum(self, other: Self, value: f64) -> Self {
        Self {
            value,
            magnitude: self.magnitude + other.magnitude,
            roundings: self.roundings.max(other.roundings) + 1,
        }
    }
}

impl Add for Counted {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.sum(other, self.value + other.value)
    }
}

impl Sub for Counted {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.sum(other, self.value - other.value)
    }
}

impl Mul for Counted {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            magnitude: self.magnitude * other.magnitude,
            roundings: self.roundings + other.roundings + 1,
        }
    }
}
