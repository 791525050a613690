//! Interval arithmetic with outward rounding in software.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

/// A closed interval of real numbers that contains the exact result, in spite of rounding.
///
/// Its ends may be infinite, after an overflow, but are never NaN.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Enclosure {
    pub(crate) lower: f64,
    pub(crate) upper: f64,
}

const WHOLE: Enclosure = Enclosure {
    lower: f64::NEG_INFINITY,
    upper: f64::INFINITY,
};

impl Enclosure {
    pub(crate) const ZERO: Self = Self {
        lower: 0.0,
        upper: 0.0,
    };

    pub(crate) fn new(lower: f64, upper: f64) -> Self {
        Self { lower, upper }
    }

    /// The whole line in place of an interval with a NaN, which comes from infinities that cancel.
    fn or_whole(self) -> Self {
        if self.lower <= self.upper { self } else { WHOLE }
    }

    pub(crate) fn middle(self) -> f64 {
        0.5 * (self.lower + self.upper)
    }

    pub(crate) fn contains_zero(self) -> bool {
        self.lower <= 0.0 && self.upper >= 0.0
    }

    /// The sign of all numbers in the interval, if it is the same.
    pub(crate) fn sign(self) -> Option<Ordering> {
        if self.lower > 0.0 {
            Some(Ordering::Greater)
        } else if self.upper < 0.0 {
            Some(Ordering::Less)
        } else if self == Self::ZERO {
            Some(Ordering::Equal)
        } else {
            None
        }
    }
}

/// The single number x.
impl From<f64> for Enclosure {
    fn from(x: f64) -> Self {
        Self::new(x, x)
    }
}

/// fl(a + b), and true if it is exact: then Knuth's error term is zero. The sum of two f64 never
/// underflows.
fn sum(a: f64, b: f64) -> (f64, bool) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b) == 0.0)
}

impl Add for Enclosure {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        let ((lower, lower_is_exact), (upper, upper_is_exact)) =
            (sum(self.lower, other.lower), sum(self.upper, other.upper));
        Self {
            lower: if lower_is_exact { lower } else { lower.next_down() },
            upper: if upper_is_exact { upper } else { upper.next_up() },
        }
        .or_whole()
    }
}

impl Neg for Enclosure {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.upper, -self.lower)
    }
}

impl Sub for Enclosure {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// fl(a · b), moved by one ulp unless a factor is zero; the ends of an interval may be infinite,
/// and stand for large numbers.
fn product(a: f64, b: f64, outward: impl Fn(f64) -> f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { outward(a * b) }
}

impl Mul for Enclosure {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        // Two products instead of four if a factor is not negative, like t, u or v.
        if other.lower >= 0.0 {
            let of_lower = if self.lower < 0.0 {
                other.upper
            } else {
                other.lower
            };
            let of_upper = if self.upper < 0.0 {
                other.lower
            } else {
                other.upper
            };
            return Self {
                lower: product(self.lower, of_lower, f64::next_down),
                upper: product(self.upper, of_upper, f64::next_up),
            };
        }
        if self.lower >= 0.0 {
            return other * self;
        }
        let factors = [
            (self.lower, other.lower),
            (self.lower, other.upper),
            (self.upper, other.lower),
            (self.upper, other.upper),
        ];
        let lower = factors.map(|(a, b)| product(a, b, f64::next_down));
        let upper = factors.map(|(a, b)| product(a, b, f64::next_up));
        Self {
            lower: lower.into_iter().fold(f64::INFINITY, f64::min),
            upper: upper.into_iter().fold(f64::NEG_INFINITY, f64::max),
        }
    }
}

#[cfg(test)]
mod tests {
    use dashu_ratio::RBig;
    use proptest::prelude::*;

    use super::*;

    /// Numbers whose sums and products are rounded, overflow, or underflow, and whose bits interact.
    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            3 => -1.0..1.0,
            1 => any::<f64>().prop_filter("finite", |x| x.is_finite()),
            1 => prop_oneof![Just(0.0), Just(f64::MIN_POSITIVE), Just(5e-324), Just(f64::MAX), Just(1e-160)],
        ]
    }

    /// Two ends and a number between.
    fn interval() -> impl Strategy<Value = (Enclosure, f64)> {
        [number(), number(), number()].prop_map(|mut numbers| {
            numbers.sort_by(f64::total_cmp);
            let [lower, inside, upper] = numbers;
            (Enclosure::new(lower, upper), inside)
        })
    }

    fn exactly(x: f64) -> RBig {
        RBig::try_from(x).unwrap()
    }

    fn contains(interval: Enclosure, x: &RBig) -> bool {
        let is_below = |end: f64| end == f64::NEG_INFINITY || end.is_finite() && exactly(end) <= *x;
        let is_above = |end: f64| end == f64::INFINITY || end.is_finite() && exactly(end) >= *x;
        is_below(interval.lower) && is_above(interval.upper)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        /// Against exact arithmetic. Intervals of single numbers are the sharpest test.
        #[test]
        fn results_contain_the_results_of_members(
            (x, a) in interval(),
            (y, b) in interval(),
            are_single in any::<bool>(),
        ) {
            let [x, y] = if are_single { [a, b].map(Enclosure::from) } else { [x, y] };
            let [a, b] = [a, b].map(exactly);
            prop_assert!(contains(x + y, &(&a + &b)));
            prop_assert!(contains(x - y, &(&a - &b)));
            prop_assert!(contains(x * y, &(&a * &b)));
        }

        #[test]
        fn exact_sums_are_not_widened(a in -1000..1000i32, b in -1000..1000i32) {
            let [x, y] = [a, b].map(|x: i32| Enclosure::from(f64::from(x)));
            prop_assert_eq!(x + y, Enclosure::from(f64::from(a + b)));
        }
    }

    #[test]
    fn zero_times_infinity_is_zero() {
        assert_eq!(Enclosure::ZERO * WHOLE, Enclosure::ZERO);
        assert_eq!((WHOLE - WHOLE), WHOLE);
    }
}
