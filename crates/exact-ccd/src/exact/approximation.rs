//! Numbers known to within an error.

use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

/// A number: m 2ᵏ for the middle m and the unit k, or one that differs from it by less than 2ᵉ units for
/// the error e.
#[derive(Clone, Debug)]
pub(super) struct Approximation {
    pub(super) middle: IBig,
    pub(super) unit: isize,
    pub(super) error: Option<usize>,
}

impl Approximation {
    /// An integer.
    pub(super) fn exactly(middle: IBig) -> Self {
        Self {
            middle,
            unit: 0,
            error: None,
        }
    }

    /// The sign, if the error does not hide it.
    pub(super) fn sign(&self) -> Option<Ordering> {
        self.is_known_to(0).then(|| self.middle.cmp(&IBig::ZERO))
    }

    /// Returns true if the error is less than 2⁻ᵏ of the middle.
    pub(super) fn is_known_to(&self, bits: usize) -> bool {
        self.missing(bits) == 0
    }

    /// The number of bits by which the middle is too short for an error of less than 2⁻ᵏ of it.
    pub(super) fn missing(&self, bits: usize) -> usize {
        let needed = |error: usize| (error + bits + 1).saturating_sub(self.middle.bit_len());
        self.error.map_or(0, needed)
    }

    /// The exponent of the least power of two above the magnitude of the middle.
    pub(super) fn top(&self) -> isize {
        self.unit.saturating_add_unsigned(self.middle.bit_len())
    }

    /// A k such that the magnitude of the number is less than 2ᵏ.
    pub(super) fn bound(&self) -> isize {
        let bits = self.middle.bit_len().max(self.error.unwrap_or_default());
        self.unit.saturating_add_unsigned(bits + 1)
    }

    /// The middle in units of 2ᵏ, rounded down.
    pub(super) fn in_units(&self, unit: isize) -> IBig {
        shifted(&self.middle, self.unit - unit)
    }
}

/// x 2ᵏ, rounded down.
pub(super) fn shifted(x: &IBig, by: isize) -> IBig {
    if by < 0 {
        x >> by.unsigned_abs()
    } else {
        x << by.unsigned_abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_known_holds_for_all_numbers_within_the_error() {
        for middle in -40_i64..=40 {
            for error in 0..8 {
                let number = Approximation {
                    middle: middle.into(),
                    unit: 0,
                    error: Some(error),
                };
                let off = 1_i64 << error;
                match number.sign() {
                    Some(Ordering::Greater) => assert!(middle - off >= 0),
                    Some(Ordering::Less) => assert!(middle + off <= 0),
                    sign => assert_eq!(sign, None),
                }
                assert!(middle.abs() + off <= 1 << number.bound());
                for bits in 0..6 {
                    assert!(!number.is_known_to(bits) || off << bits <= middle.abs());
                }
            }
        }
    }
}
