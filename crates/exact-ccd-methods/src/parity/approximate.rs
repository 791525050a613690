//! Numbers in f64 with an error bound.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

/// A polynomial in f64 numbers, computed in f64, and the sum of the magnitudes of its terms.
///
/// Let k be the most operations on a path from a coordinate to the result. Each term of the value is off
/// by a factor between (1 − u)ᵏ and (1 + u)ᵏ, u = 2⁻⁵³, and so is the magnitude, whose terms all have one
/// sign. Hence the error of the value is at most ((1 + u)ᵏ − 1) / (1 − u)ᵏ times the magnitude, which is
/// less than 16 u for k ≤ 12: a determinant has 5 operations, φ has 12.
///
/// Nothing overflows or underflows in range (`Expansion::can_hold`). Only the normal of a
/// plane has smaller components, and three products with such a component underflow by 2⁻¹⁰⁷⁵ each.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Approximate {
    pub(super) value: f64,
    magnitude: f64,
}

impl From<f64> for Approximate {
    #[inline]
    fn from(x: f64) -> Self {
        Self {
            value: x,
            magnitude: x.abs(),
        }
    }
}

impl Approximate {
    /// The sign, if the error bound leaves no other.
    #[inline]
    pub(super) fn sign(self) -> Option<Ordering> {
        // 16 u of the magnitude, and more than the underflow.
        let error = 8.0 * f64::EPSILON * self.magnitude + f64::MIN_POSITIVE;
        if self.value > error {
            Some(Ordering::Greater)
        } else if self.value < -error {
            Some(Ordering::Less)
        } else {
            (self.magnitude == 0.0).then_some(Ordering::Equal)
        }
    }
}

/// An operation on values, and the one on the sums of the magnitudes of their terms.
macro_rules! operation {
    ($operation:ident, $name:ident, $of_values:tt, $of_magnitudes:tt) => {
        impl $operation for Approximate {
            type Output = Self;

            #[inline]
            fn $name(self, other: Self) -> Self {
                Self {
                    value: self.value $of_values other.value,
                    magnitude: self.magnitude $of_magnitudes other.magnitude,
                }
            }
        }
    };
}

operation!(Add, add, +, +);
operation!(Sub, sub, -, +);
operation!(Mul, mul, *, *);
