//! Lengths and areas in integers of two widths: the short ones serve where coordinates have one size, the
//! long ones where some are far smaller than others on their axis, as rounded zeros are.

use core::cmp::Ordering;
use core::ops::{Add, Shl, Shr, Sub};

use super::wide::Wide;

/// An integer of 384 bits, for products of three lengths.
pub(super) type Volume = Wide<6>;

/// An integer of 256 bits, for products of two long lengths.
pub(super) type LongArea = Wide<4>;

/// A difference of two coordinates.
///
/// If coordinates are below 2ᵇ, lengths are below 2ᵇ⁺¹, the terms of a coefficient of the cubic below
/// 2³ᵇ⁺³, and there are at most 18 of them. Without [the roots at the ends](super::zeros::without_ends),
/// a coefficient is a sum of at most three: below 54 · 2³ᵇ⁺³, which is less than 2³⁷⁸ for b = 123.
pub(super) trait Length: Copy + Default + PartialEq + Into<i128> + Sub<Output = Self> {
    /// The largest number of bits of coordinates.
    const MOST_BITS: u32;

    /// The product of two lengths, and sums of at most six of them.
    type Area: Area;

    /// The floor of m 2ᵉ⁻ᵏ for a coordinate m 2⁻ᵏ, and true if it is exact. e is
    /// [`MOST_BITS`](Self::MOST_BITS) − 53, so that the result is below 2 to the power `MOST_BITS` for
    /// every m below 2⁵³ and k ≥ 0.
    fn scaled(mantissa: i64, k: u32) -> (Self, bool);

    /// The nearest f64.
    fn value(self) -> f64 {
        let integer: i128 = self.into();
        integer as f64
    }

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

    fn widened(self) -> LongArea;
}

/// If coordinates are below 2ᵇ, lengths are below 2ᵇ⁺¹ and six products of them below 2²ᵇ⁺⁵: 2¹²⁷ for b = 61.
impl Length for i64 {
    const MOST_BITS: u32 = 61;
    type Area = i128;

    #[inline(always)]
    fn scaled(mantissa: i64, k: u32) -> (Self, bool) {
        halved(mantissa << (Self::MOST_BITS - f64::MANTISSA_DIGITS), k)
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

/// The floor of x 2⁻ᵏ, and true if it is exact.
#[inline(always)]
fn halved<T: Copy + PartialEq + Shl<u32, Output = T> + Shr<u32, Output = T>>(x: T, k: u32) -> (T, bool) {
    // More halvings leave 0 or −1 too, which is exact for 0 only.
    let k = k.min(8 * size_of::<T>() as u32 - 1);
    let floor = x >> k;
    (floor, floor << k == x)
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
    fn widened(self) -> LongArea {
        self.into()
    }
}

/// Six products are below 2²ᵇ⁺⁵: 2²⁵¹ for b = 123.
impl Length for i128 {
    const MOST_BITS: u32 = 123;
    type Area = LongArea;

    fn scaled(mantissa: i64, k: u32) -> (Self, bool) {
        halved(
            Self::from(mantissa) << (Self::MOST_BITS - f64::MANTISSA_DIGITS),
            k,
        )
    }

    fn times(self, other: Self) -> LongArea {
        LongArea::from(self) * other.into()
    }

    fn volume(self, area: LongArea) -> Volume {
        Volume::from(self) * Wide::widened(area)
    }
}

impl Area for LongArea {
    fn sign(self) -> Ordering {
        Self::sign(&self)
    }

    fn value(self) -> f64 {
        self.approximate().high
    }

    fn widened(self) -> LongArea {
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A triple product of lengths below 2¹⁶, which fits in 128 bits.
    fn volume_of<L: Length>([a, b, c]: [i64; 3]) -> Volume {
        let scaled = |x: i64| L::scaled(x, L::MOST_BITS - f64::MANTISSA_DIGITS).0;
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
            assert!(areas == [LongArea::from(a * b); 2], "{lengths:?}");
            assert_eq!(lengths.map(Length::value), lengths.map(|x| x as f64));
            assert_eq!([a, b, c].map(Length::value), lengths.map(|x| x as f64));
        }
    }

    #[test]
    fn a_coordinate_is_halved_to_an_integer_or_its_floor() {
        for k in (0..=140).chain([u32::MAX]) {
            for mantissa in [0, 1, -1, 3, -3, 1 << 52, -(1 << 52), (1 << 53) - 1, 1 - (1 << 53)] {
                let check = |scaled: (i128, bool), bits: u32| {
                    let whole = i128::from(mantissa) << (bits - 53);
                    let unit = 1_i128 << k.min(126);
                    let expected = (whole.div_euclid(unit), whole.rem_euclid(unit) == 0);
                    assert_eq!(scaled, expected, "{mantissa} {k}");
                };
                check(<i128 as Length>::scaled(mantissa, k), 123);
                let (short, is_integer) = <i64 as Length>::scaled(mantissa, k);
                check((short.into(), is_integer), 61);
            }
        }
    }
}
