//! What the polynomials are computed in.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use dashu_int::IBig;

use crate::interval::Interval;

/// A number, up to its sign.
pub(super) trait Number:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// n times as much.
    fn times(self, n: u8) -> Self;

    /// The sign; `Equal` for zero, and also where an error bound leaves the sign open and the method is to go on without it.
    /// None where it is to stop.
    fn sign(&self) -> Option<Ordering>;

    /// Whether this is zero for certain.
    fn is_zero(&self) -> bool;
}

/// As it was rounded.
impl Number for f64 {
    fn times(self, n: u8) -> Self {
        self * f64::from(n)
    }

    fn sign(&self) -> Option<Ordering> {
        self.partial_cmp(&0.0)
    }

    fn is_zero(&self) -> bool {
        *self == 0.0
    }
}

impl Number for Interval {
    fn times(self, n: u8) -> Self {
        self * Self::exactly(n.into())
    }

    fn sign(&self) -> Option<Ordering> {
        Self::sign(*self)
    }

    fn is_zero(&self) -> bool {
        *self == Self::ZERO
    }
}

impl Number for IBig {
    fn times(self, n: u8) -> Self {
        self * n
    }

    fn sign(&self) -> Option<Ordering> {
        Some(self.cmp(&Self::ZERO))
    }

    fn is_zero(&self) -> bool {
        Self::is_zero(self)
    }
}

/// The signs of several numbers.
pub(super) fn signs<N: Number, const M: usize>(numbers: [&N; M]) -> Option<[Ordering; M]> {
    let mut signs = [Ordering::Equal; M];
    for (sign, number) in signs.iter_mut().zip(numbers) {
        *sign = number.sign()?;
    }
    Some(signs)
}
