//! Integers of fixed width: exact arithmetic without allocation.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use crate::numbers::double_double::DoubleDouble;

/// An integer of N words, the least significant first, in two's complement.
///
/// All operations are modulo 2⁶⁴ᴺ. A result whose magnitude is less than half of that is exact, whatever
/// the intermediate results: users derive bounds of their results only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Wide<const N: usize>([u64; N]);

/// The number of leading bits from which an approximation is made.
const LEADING: u32 = 126;

impl<const N: usize> Wide<N> {
    pub(super) const ZERO: Self = Self([0; N]);

    pub(super) fn is_zero(&self) -> bool {
        *self == Self::ZERO
    }

    fn is_negative(&self) -> bool {
        self.0[N - 1] >> 63 != 0
    }

    /// The sign.
    pub(super) fn sign(&self) -> Ordering {
        if self.is_negative() {
            Ordering::Less
        } else if self.is_zero() {
            Ordering::Equal
        } else {
            Ordering::Greater
        }
    }

    pub(super) fn magnitude(self) -> Self {
        if self.is_negative() { -self } else { self }
    }

    /// The same integer in at least as many words.
    pub(super) fn widened<const M: usize>(self) -> Wide<M> {
        let fill = if self.is_negative() { u64::MAX } else { 0 };
        Wide(core::array::from_fn(|i| self.0.get(i).copied().unwrap_or(fill)))
    }

    /// The number of bits of the magnitude.
    pub(super) fn bit_len(self) -> u32 {
        let words = self.magnitude().0;
        let used = words.iter().rposition(|&word| word != 0);
        used.map_or(0, |last| 64 * (last as u32 + 1) - words[last].leading_zeros())
    }

    /// The quotient by 2ᵏ, rounded down, if 128 bits hold it.
    #[inline]
    fn shifted_right(self, k: u32) -> i128 {
        let (words, bits) = ((k / 64) as usize, k % 64);
        let fill = if self.is_negative() { u64::MAX } else { 0 };
        let word = |i: usize| u128::from(self.0.get(i).copied().unwrap_or(fill));
        let pair = |i: usize| ((word(i + 1) << 64 | word(i)) >> bits) as u64;
        (u128::from(pair(words + 1)) << 64 | u128::from(pair(words))) as i128
    }

    /// The integer, if 64 bits hold it.
    #[inline]
    fn short(&self) -> Option<i64> {
        let (&first, rest) = self.0.split_first()?;
        let first = first as i64;
        let has_its_sign = |&word: &u64| word as i64 == first >> 63;
        rest.iter().all(has_its_sign).then_some(first)
    }

    /// An approximation whose relative error is less than 2⁻¹⁰⁴.
    ///
    /// The leading bits are cut off after [`LEADING`], which is three times 42. Each third is exactly an f64,
    /// and the sum of the first two exactly a double-double h + l. If l is not zero, |h| is at least 2⁹⁵, so
    /// that l and the last third are at most 2⁻⁵³ |h| each: their sum is off by at most 2⁻¹⁰⁵ |h|. If l is
    /// zero, that sum is exact. The bits that are cut off are below 2⁻¹²⁵ of the integer.
    pub(super) fn approximate(self) -> DoubleDouble {
        const THIRD: u32 = LEADING / 3;
        const MASK: i128 = (1 << THIRD) - 1;
        const UNIT: f64 = (1_u64 << THIRD) as f64;
        let shift = self.bit_len().saturating_sub(LEADING);
        let leading = self.shifted_right(shift);
        let scale = f64::from_bits(u64::from(1023 + shift) << 52);
        let [first, second, third] = [leading >> (2 * THIRD), leading >> THIRD & MASK, leading & MASK]
            .map(|part| part as i64 as f64 * scale);
        let sum = DoubleDouble::sum(first * UNIT * UNIT, second * UNIT);
        DoubleDouble::sum(sum.high, sum.low + third)
    }

    /// The product with a weight from 0 to 2⁶³.
    #[inline]
    pub(super) fn times(self, weight: u64) -> Self {
        self.weighted(weight, Self::ZERO, 0)
    }

    /// The sum of two products with weights from 0 to 2⁶³, so that each carry is below 2⁶⁴.
    #[inline]
    pub(super) fn weighted(self, weight: u64, other: Self, other_weight: u64) -> Self {
        let mut sum = Self::ZERO;
        let mut carry = 0;
        for i in 0..N {
            let terms = u128::from(self.0[i]) * u128::from(weight)
                + u128::from(other.0[i]) * u128::from(other_weight);
            let terms = terms + u128::from(carry);
            sum.0[i] = terms as u64;
            carry = (terms >> 64) as u64;
        }
        sum
    }

    /// The product of integers of 64 and 128 bits, for N > 2.
    #[inline(always)]
    pub(super) fn product(a: i64, b: i128) -> Self {
        let a = i128::from(a);
        let low = a * i128::from(b as u64);
        let high = a * (b >> 64) + (low >> 64);
        Self(core::array::from_fn(|i| match i {
            0 => low as u64,
            1 => high as u64,
            2 => (high >> 64) as u64,
            _ => (high >> 127) as u64,
        }))
    }
}

impl<const N: usize> From<i128> for Wide<N> {
    #[inline]
    fn from(value: i128) -> Self {
        Self(core::array::from_fn(|i| match i {
            0 => value as u64,
            1 => (value >> 64) as u64,
            _ => (value >> 127) as u64,
        }))
    }
}

impl<const N: usize> Add for Wide<N> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        let mut carry = false;
        Self(core::array::from_fn(|i| {
            let (sum, first) = self.0[i].overflowing_add(other.0[i]);
            let (sum, second) = sum.overflowing_add(carry.into());
            carry = first | second;
            sum
        }))
    }
}

impl<const N: usize> Neg for Wide<N> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::ZERO - self
    }
}

impl<const N: usize> Sub for Wide<N> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        let mut borrow = false;
        Self(core::array::from_fn(|i| {
            let (difference, first) = self.0[i].overflowing_sub(other.0[i]);
            let (difference, second) = difference.overflowing_sub(borrow.into());
            borrow = first | second;
            difference
        }))
    }
}

impl<const N: usize> Mul for Wide<N> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        if let (Some(a), Some(b)) = (self.short(), other.short()) {
            return Self::from(i128::from(a) * i128::from(b));
        }
        let mut product = [0; N];
        for i in 0..N {
            let mut carry = 0;
            for j in 0..N - i {
                let term = u128::from(self.0[i]) * u128::from(other.0[j]);
                let sum = term + u128::from(product[i + j]) + u128::from(carry);
                product[i + j] = sum as u64;
                carry = (sum >> 64) as u64;
            }
        }
        Self(product)
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec;
    use alloc::vec::Vec;
    use core::cmp::Ordering;

    use dashu_int::IBig;

    use super::{DoubleDouble, Wide};

    fn big<const N: usize>(wide: Wide<N>) -> IBig {
        let words = wide.magnitude().0.into_iter().rev();
        let magnitude = words.fold(IBig::ZERO, |sum, word| (sum << 64) + IBig::from(word));
        if wide.sign().is_lt() {
            -magnitude
        } else {
            magnitude
        }
    }

    /// Integers of all lengths and both signs, with runs of zeros and ones.
    fn integers() -> Vec<i128> {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        let mut all = vec![0, 1, -1];
        for length in 1..=120 {
            bits = bits.wrapping_mul(0xd134_2543_de82_ef95).wrapping_add(1);
            let noise = (i128::from(bits) * i128::from(bits >> 5)) & ((1 << length) - 1);
            let power = 1_i128 << length;
            all.extend([noise, -noise, power, -power, power - 1, 1 - power]);
        }
        all
    }

    #[test]
    fn arithmetic_is_that_of_integers() {
        let all = integers();
        for &a in &all {
            for &b in all.iter().step_by(7) {
                let [x, y] = [a, b].map(Wide::<4>::from);
                let [i, j] = [a, b].map(IBig::from);
                assert_eq!(big(x + y), &i + &j, "{a} {b}");
                assert_eq!(big(x - y), &i - &j, "{a} {b}");
                assert_eq!(big(x * y), &i * &j, "{a} {b}");
                let short = a.clamp(i64::MIN.into(), i64::MAX.into()) as i64;
                assert_eq!(big(x.times(3)), IBig::from(3) * &i, "{a} {b}");
                for [weight, other] in [[0, 1], [1 << 63, 1 << 63], [short.unsigned_abs() >> 1, 3]] {
                    let sum = IBig::from(weight) * &i + IBig::from(other) * &j;
                    assert_eq!(big(x.weighted(weight, y, other)), sum, "{a} {b} {weight}");
                }
                assert_eq!(
                    big(Wide::<4>::product(short, b)),
                    IBig::from(short) * &j,
                    "{a} {b}"
                );
                let [x, y] = [a, b].map(Wide::<6>::from);
                assert_eq!(big(x * y * x), &i * &j * &i, "{a} {b}");
                assert_eq!((x * y).sign(), (&i * &j).cmp(&IBig::ZERO), "{a} {b}");
            }
        }
    }

    #[test]
    fn approximations_are_as_accurate_as_stated() {
        let all = integers();
        for (&a, &b) in all.iter().zip(all.iter().rev()) {
            let product = Wide::<4>::from(a) * Wide::from(b);
            let DoubleDouble { high, low } = product.approximate();
            let exact = IBig::from(a) * IBig::from(b);
            let to_big = |x: f64| {
                let ([integer], unit) = crate::exact::to_integers([x * 1024.0]);
                integer << (unit.unwrap_or_default() + 200) as usize
            };
            let error = to_big(high) + to_big(low) - (exact.clone() << 210);
            let bound = exact.clone() << 106;
            let size = |x: &IBig| if x.cmp(&IBig::ZERO).is_lt() { -x } else { x.clone() };
            assert!(size(&error) <= size(&bound), "{a} {b}");
            assert_eq!(high.partial_cmp(&0.0), Some(product.sign()), "{a} {b}");
            assert_eq!(product.sign(), exact.cmp(&IBig::ZERO));
            assert_ne!(product.sign() == Ordering::Equal, product.bit_len() > 0);
        }
    }

    #[test]
    fn integers_of_many_words_are_not_short() {
        for rest in [1, 2, u64::MAX - 1] {
            let [x, three] = [Wide([5, rest, rest, rest]), Wide::<4>::from(3)];
            assert_eq!((x * three).0, (x + x + x).0);
            assert_eq!((three * x).0, (x + x + x).0);
        }
    }
}
