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
/// 2³ᵇ⁺³, and there are at most 18 of them. Without [the roots at the ends](super::zeros::without_ends),
/// a coefficient is a sum of at most three: below 54 · 2³ᵇ⁺³, which is less than 2²⁵² for b = 81.
pub(super) trait Length: Copy + Default + PartialEq + Into<i128> {
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
pub(super) trait Area: Copy + PartialEq + Add<Output = Self> + Sub<Output = Self> {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A triple product of lengths below 2¹⁶, which fits in 128 bits.
    fn volume_of<L: Length>([a, b, c]: [i64; 3]) -> Volume {
        let scaled = |x: i64| L::scaled(x, 0);
        scaled(a).volume(scaled(b).times(scaled(c)))
    }

    #[test]
    fn both_widths_are_integers() {
        let mut random = fastrand::Rng::with_seed(1);
        for _ in 0..1000 {
            let lengths = [(); 3].map(|()| random.i64(-(1 << 40)..1 << 40));
            let [a, b, c] = lengths.map(i128::from);
            let volume = Volume::from(a) * Volume::from(b * c);
            assert!(volume_of::<i64>(lengths) == volume, "{lengths:?}");
            assert!(volume_of::<i128>(lengths) == volume, "{lengths:?}");
            let areas = [
                <i64 as Length>::times(lengths[0], lengths[1]).widened(),
                <i128 as Length>::times(a, b).widened(),
            ];
            assert!(areas == [Volume::from(a * b); 2], "{lengths:?}");
        }
    }

    #[test]
    fn a_coordinate_is_a_power_of_two_of_its_mantissa() {
        for k in -70..=8_i32 {
            for mantissa in [0, 1, -1, 3, 1 << 52, -(1 << 52)] {
                // It fits, or it is 0.
                let unit = 1_i128 << k.unsigned_abs();
                let wide = if k < 0 {
                    i128::from(mantissa) / unit
                } else {
                    i128::from(mantissa) * unit
                };
                let is_integer = k >= 0 || i128::from(mantissa) % unit == 0;
                if is_integer {
                    assert_eq!(<i128 as Length>::scaled(mantissa, k), wide, "{mantissa} {k}");
                    assert_eq!(
                        <i64 as Length>::scaled(mantissa, k),
                        wide as i64,
                        "{mantissa} {k}"
                    );
                }
            }
        }
    }
}
