//! Lengths and areas in integers of two widths: the short ones serve nearly all queries, the long ones the
//! rest.

use core::cmp::Ordering;
use core::ops::{Add, Shl, Shr, Sub};

use super::wide::Wide;

/// An integer of 256 bits: all that has three factors.
pub(super) type Volume = Wide<4>;

/// A difference of two coordinates.
///
/// If coordinates are below 2ᵇ, lengths are below 2ᵇ⁺¹, the terms of a coefficient of the cubic below
/// 2³ᵇ⁺³, and there are at most 18 of them. Without [the roots at the ends](super::lattice::without_ends),
/// a coefficient is a sum of at most three: below 54 · 2³ᵇ⁺³, which is less than 2²⁵² for b = 81.
pub(super) trait Length: Copy {
    /// The largest number of bits of coordinates.
    const MOST_BITS: u32;

    /// The product of two lengths, and sums of at most six of them.
    type Area: Area;

    /// A coordinate m 2ᵏ, an integer below 2 to the power [`MOST_BITS`](Self::MOST_BITS); 0 for m = 0.
    fn scaled(mantissa: i64, k: i32) -> Self;

    /// The nearest f64.
    fn value(self) -> f64;

    /// a − b.
    fn minus(self, other: Self) -> Self;

    /// a b.
    fn times(self, other: Self) -> Self::Area;

    /// The product of a length and an area.
    fn volume(self, area: Self::Area) -> Volume;
}

/// A sum of products of two lengths.
pub(super) trait Area: Copy + Add<Output = Self> + Sub<Output = Self> {
    fn sign(self) -> Ordering;

    /// An approximation, rounded once.
    fn value(self) -> f64;

    fn widened(self) -> Volume;
}

/// If coordinates are below 2ᵇ, lengths are below 2ᵇ⁺¹ and six products of them below 2²ᵇ⁺⁵: 2¹²⁷ for b = 61.
impl Length for i64 {
    const MOST_BITS: u32 = 61;
    type Area = i128;

    #[inline(always)]
    fn scaled(mantissa: i64, k: i32) -> Self {
        shifted(mantissa, k)
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        self - other
    }

    fn value(self) -> f64 {
        self as f64
    }

    #[inline(always)]
    fn times(self, other: Self) -> i128 {
        i128::from(self) * i128::from(other)
    }

    #[inline(always)]
    fn volume(self, area: i128) -> Volume {
        Volume::product(self, area)
    }
}

/// x 2ᵏ, if that is an integer that fits.
#[inline(always)]
fn shifted<T: Shl<u32, Output = T> + Shr<u32, Output = T>>(x: T, k: i32) -> T {
    // A shift that is too long is that of zero.
    let most = 8 * size_of::<T>() as u32 - 1;
    if k >= 0 {
        x << (k as u32).min(most)
    } else {
        x >> k.unsigned_abs().min(most)
    }
}

impl Area for i128 {
    #[inline(always)]
    fn sign(self) -> Ordering {
        self.cmp(&0)
    }

    #[inline(always)]
    fn value(self) -> f64 {
        self as f64
    }

    #[inline(always)]
    fn widened(self) -> Volume {
        self.into()
    }
}

impl Length for i128 {
    const MOST_BITS: u32 = 81;
    type Area = Volume;

    fn scaled(mantissa: i64, k: i32) -> Self {
        shifted(Self::from(mantissa), k)
    }

    fn minus(self, other: Self) -> Self {
        self - other
    }

    fn value(self) -> f64 {
        self as f64
    }

    fn times(self, other: Self) -> Volume {
        Volume::from(self) * other.into()
    }

    fn volume(self, area: Volume) -> Volume {
        Volume::from(self) * area
    }
}

impl Area for Volume {
    fn sign(self) -> Ordering {
        Self::sign(&self)
    }

    fn value(self) -> f64 {
        self.approximate().high
    }

    fn widened(self) -> Volume {
        self
    }
}
