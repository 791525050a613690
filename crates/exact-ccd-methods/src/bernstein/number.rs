//! The numbers of the polynomials.

use std::cmp::Ordering;
use std::ops::Neg;

use dashu_int::IBig;

use crate::interval::Enclosure;
use crate::ring::Ring;

/// A coefficient.
pub(super) trait Number: Ring + Neg<Output = Self> {
    /// The product with n.
    fn times(self, n: u8) -> Self;
}

/// A coefficient with a sign. The default is zero. It equals only coefficients that are certainly zero.
pub(super) trait Signed: Number + Default + PartialEq {
    /// The sign. `Equal` stands for zero, and for a sign that an error bound leaves open if the
    /// method continues without it. `None` is an open sign at which the method stops.
    fn sign(&self) -> Option<Ordering>;
}

impl Number for f64 {
    fn times(self, n: u8) -> Self {
        self * f64::from(n)
    }
}

impl Number for Enclosure {
    fn times(self, n: u8) -> Self {
        self * Self::from(f64::from(n))
    }
}

impl Signed for Enclosure {
    fn sign(&self) -> Option<Ordering> {
        Self::sign(*self)
    }
}

impl Number for IBig {
    fn times(self, n: u8) -> Self {
        self * n
    }
}

impl Signed for IBig {
    fn sign(&self) -> Option<Ordering> {
        Some(self.cmp(&Self::ZERO))
    }
}

/// The signs of several numbers.
pub(super) fn signs<N: Signed, const M: usize>(numbers: [&N; M]) -> Option<[Ordering; M]> {
    let mut signs = [Ordering::Equal; M];
    for (sign, number) in signs.iter_mut().zip(numbers) {
        *sign = number.sign()?;
    }
    Some(signs)
}
