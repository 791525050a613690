//! The numbers of the polynomials.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use dashu_int::IBig;

use crate::interval::Interval;

/// A number, up to its sign.
pub(super) trait Number:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// The product with n.
    fn times(self, n: u8) -> Self;

    /// The sign. `Equal` stands for zero, and for a sign that an error bound leaves open if the
    /// method continues without it. `None` is an open sign at which the method stops.
    fn sign(&self) -> Option<Ordering>;

    /// Returns true if this is zero for certain.
    fn is_zero(&self) -> bool;
}

/// Rounded arithmetic, whose signs are taken as they are.
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
