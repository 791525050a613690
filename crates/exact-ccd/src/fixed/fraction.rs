//! Times that are quotients of integers.

use core::cmp::Ordering;

use super::dyadic::Dyadic;
use crate::values::ContactTime;

/// The time elapsed / (elapsed + left) of the step. Both numbers are below 2⁶³, and not both are 0.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fraction {
    left: u64,
    elapsed: u64,
}

impl Fraction {
    pub(super) const START: Self = Self { left: 1, elapsed: 0 };
    pub(super) const END: Self = Self { left: 0, elapsed: 1 };

    /// The time inside the step at which a linear function from one integer to another vanishes, if it does
    /// and the time is not too long.
    pub(super) fn zero_of(start: i128, end: i128) -> Option<Self> {
        if start == 0 || end == 0 || (start < 0) == (end < 0) {
            return None;
        }
        let [elapsed, left] = [start, end].map(i128::unsigned_abs);
        let twos = (elapsed | left).trailing_zeros();
        let short = |parts: u128| u64::try_from(parts >> twos).ok().filter(|parts| parts >> 63 == 0);
        Some(Self {
            left: short(left)?,
            elapsed: short(elapsed)?,
        })
    }

    /// The parts that are left, and the parts that have elapsed.
    pub(super) fn weights(self) -> [u64; 2] {
        [self.left, self.elapsed]
    }

    /// The f64 at this time, or the two adjacent ones around it.
    pub(super) fn time(self) -> ContactTime {
        if self.elapsed == 0 {
            return ContactTime::exactly(0.0);
        }
        let whole = u128::from(self.left) + u128::from(self.elapsed);
        let elapsed = u128::from(self.elapsed);
        // The quotient times 2 to this power is between 2⁵² and 2⁵⁴. The dividend is below 2⁵⁴ times the
        // divisor, which is below 2⁶⁴.
        let shift = f64::MANTISSA_DIGITS + whole.ilog2() - elapsed.ilog2();
        let (quotient, rest) = ((elapsed << shift) / whole, (elapsed << shift) % whole);
        let excess = quotient >> f64::MANTISSA_DIGITS;
        let floor = libm::ldexp((quotient >> excess) as f64, excess as i32 - shift as i32);
        if rest == 0 && quotient & excess == 0 {
            ContactTime::exactly(floor)
        } else {
            ContactTime::just_above(floor)
        }
    }
}

impl Ord for Fraction {
    fn cmp(&self, other: &Self) -> Ordering {
        let product = |elapsed: &Self, left: &Self| u128::from(elapsed.elapsed) * u128::from(left.left);
        product(self, other).cmp(&product(other, self))
    }
}

impl PartialOrd for Fraction {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Fraction {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Fraction {}

impl From<Dyadic> for Fraction {
    fn from(time: Dyadic) -> Self {
        let [left, elapsed] = time.weights();
        Self { left, elapsed }
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::*;

    fn fraction(elapsed: u64, left: u64) -> Fraction {
        Fraction { left, elapsed }
    }

    #[test]
    fn zeros_of_linear_functions_are_inside_the_step() {
        for (ends, expected) in [
            ([-1, 2], Some([2, 1])),
            ([12, -4], Some([1, 3])),
            ([1, 2], None),
            ([-1, -2], None),
            ([0, 1], None),
            ([0, -1], None),
            ([1, -2], Some([2, 1])),
            ([-1, 0], None),
            ([0, 0], None),
            ([-(1 << 63), 1], None),
            ([1 - (1 << 63), 1], Some([1, (1 << 63) - 1])),
            ([i128::MIN, 1 << 126], Some([1, 2])),
            ([i128::MIN, 1], None),
        ] {
            let found = Fraction::zero_of(ends[0], ends[1]).map(Fraction::weights);
            assert_eq!(found, expected, "{ends:?}");
        }
    }

    #[test]
    fn fractions_are_ordered_by_time() {
        let all = (0..12).flat_map(|left| (0..12).map(move |elapsed| [left, elapsed]));
        let all: Vec<_> = all.filter(|&parts| parts != [0, 0]).collect();
        for &[a, b] in &all {
            for &[c, d] in &all {
                let times = [[a, b], [c, d]].map(|[left, elapsed]| elapsed as f64 / (left + elapsed) as f64);
                let found = fraction(b, a).partial_cmp(&fraction(d, c));
                assert_eq!(found, times[0].partial_cmp(&times[1]));
                assert_eq!(fraction(b, a) == fraction(d, c), times[0] == times[1]);
            }
        }
        let most = (1 << 63) - 1;
        assert!(fraction(most, most) > fraction(most - 1, most));
        assert!(Fraction::START < fraction(1, most) && fraction(most, 1) < Fraction::END);
    }

    /// Times with up to 63 digits, compared with their products.
    #[test]
    fn times_are_rounded_down_to_numbers() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut exact = 0;
        for index in 0..20_000 {
            let mut parts = || random.u64(..1 << 63) >> random.u32(0..63);
            let (mut elapsed, mut left) = (parts(), parts());
            if index % 4 == 0 {
                // The whole is a power of two.
                let whole = 1_u64 << random.u32(0..63);
                elapsed %= whole;
                left = whole - elapsed;
            }
            if elapsed == 0 {
                continue;
            }
            let time = fraction(elapsed, left).time();
            let whole = u128::from(elapsed) + u128::from(left);
            // The sign of f − elapsed / whole, for f = m 2⁻ᵏ.
            let compare = |f: f64| {
                let (mantissa, exponent) = crate::exact::parts(f);
                let product = dashu_int::IBig::from(mantissa) * whole;
                product.cmp(&(dashu_int::IBig::from(elapsed) << usize::try_from(-exponent).expect("below 1")))
            };
            if time.is_exact() {
                assert!(compare(time.lower()).is_eq(), "{elapsed} {left}");
                exact += 1;
            } else {
                assert!(compare(time.lower()).is_lt(), "{elapsed} {left}");
                assert!(compare(time.upper()).is_gt(), "{elapsed} {left}");
            }
        }
        assert!((2_000..8_000).contains(&exact), "{exact}");
        assert_eq!(Fraction::START.time(), ContactTime::exactly(0.0));
        assert_eq!(Fraction::END.time(), ContactTime::exactly(1.0));
    }
}
