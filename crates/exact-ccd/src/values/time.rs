//! Contact times: algebraic numbers, each given as an f64 or as the two adjacent f64 around it.

use super::non_negative::NonNegative;

/// One time of contact in [0, 1]: either exactly an f64, or strictly between two adjacent ones.
///
/// Times are in their order, in every floating-point environment. Two different times between the
/// same two adjacent f64 compare equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ContactTime {
    lower: NonNegative,
    /// True if the time is above `lower`, hence after the one that is exactly `lower`.
    is_above: bool,
}

impl ContactTime {
    pub(crate) fn exactly(time: f64) -> Self {
        Self {
            lower: in_step(time),
            is_above: false,
        }
    }

    /// A time strictly between `lower` and the next larger f64.
    pub(crate) fn just_above(lower: f64) -> Self {
        Self {
            lower: in_step(lower),
            is_above: true,
        }
    }

    /// The largest f64 that is not above the time.
    #[must_use]
    pub fn lower(self) -> f64 {
        self.lower.get()
    }

    /// The smallest f64 that is not below the time.
    #[must_use]
    pub fn upper(self) -> f64 {
        if self.is_above {
            self.lower.next_up()
        } else {
            self.lower()
        }
    }

    /// Returns true if the time is exactly [`lower`](Self::lower).
    #[must_use]
    pub fn is_exact(self) -> bool {
        !self.is_above
    }

    /// Returns true for the start of the step, t = 0.
    #[must_use]
    pub fn is_start(self) -> bool {
        self == Self::exactly(0.0)
    }

    /// Returns true if the contact is not after a time t; false for NaN.
    #[must_use]
    pub fn is_at_most(self, t: f64) -> bool {
        t > 1.0 || NonNegative::new(t).is_some_and(|t| (self.lower, self.is_above) <= (t, false))
    }

    /// Returns true if the contact is before a time t; false for NaN.
    #[must_use]
    pub fn is_before(self, t: f64) -> bool {
        t > 1.0 || NonNegative::new(t).is_some_and(|t| self.lower < t)
    }
}

/// A time of the step, which is neither negative nor NaN.
#[inline]
fn in_step(time: f64) -> NonNegative {
    let time = NonNegative::new(time);
    debug_assert!(time.is_some(), "a contact time is in [0, 1]");
    time.unwrap_or(NonNegative::ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_compared_with_any_number() {
        let exact = [0.0, 0.5, 1.0_f64.next_down(), 1.0].map(ContactTime::exactly);
        for time in exact.into_iter().chain([0.0, 0.5].map(ContactTime::just_above)) {
            for t in [f64::NAN, f64::NEG_INFINITY, -1.0, -f64::from_bits(1)] {
                assert!(!time.is_at_most(t) && !time.is_before(t), "{time:?} {t}");
            }
            for t in [1.0_f64.next_up(), 2.0, f64::MAX, f64::INFINITY] {
                assert!(time.is_at_most(t) && time.is_before(t), "{time:?} {t}");
            }
            for t in [
                -0.0,
                0.0,
                f64::from_bits(1),
                0.5,
                0.5_f64.next_up(),
                1.0_f64.next_down(),
                1.0,
            ] {
                assert_eq!(time.is_at_most(t), time.upper() <= t, "{time:?} {t}");
                assert_eq!(time.is_before(t), time.lower() < t, "{time:?} {t}");
            }
        }
    }
}
