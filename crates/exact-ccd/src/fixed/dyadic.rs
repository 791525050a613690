//! Times that are integers in a small unit, in which all polynomials are exact.

/// A time that is a multiple of 2⁻⁶², in the step or a little beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Dyadic(i64);

/// The binary digits after the point.
const DIGITS: u32 = 62;

impl Dyadic {
    pub(super) const START: Self = Self(0);
    pub(super) const END: Self = Self(1 << DIGITS);

    /// This time, if it is in the step and a multiple of the unit.
    pub(super) fn new(time: f64) -> Option<Self> {
        let units = time * Self::END.0 as f64;
        let dyadic = Self(units as i64);
        ((0.0..=1.0).contains(&time) && dyadic.0 as f64 == units).then_some(dyadic)
    }

    /// The time strictly between two others that has the fewest digits.
    pub(super) fn between(low: Self, high: Self) -> Option<Self> {
        // `last` begins with the digits that it shares with `low`. Then it has a 1. All digits after that may
        // be 0.
        let last = high.0 - 1;
        (low.0 < last).then(|| {
            let shift = (low.0 ^ last).ilog2();
            Self(last >> shift << shift)
        })
    }

    /// The time a number of units later.
    pub(super) fn plus(self, units: i64) -> Self {
        Self(self.0 + units)
    }

    pub(super) fn units(self) -> i64 {
        self.0
    }

    /// The digits after the point up to the last one that is not 0.
    pub(super) fn digits(self) -> u32 {
        DIGITS.saturating_sub(self.0.trailing_zeros())
    }

    /// The units after this time, and those before it, of a time in the step.
    pub(super) fn weights(self) -> [u64; 2] {
        debug_assert!(self >= Self::START && self <= Self::END, "a time of the step");
        [Self::END.0 - self.0, self.0].map(i64::unsigned_abs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_the_step_that_are_multiples_of_the_unit_are_dyadic() {
        let unit = 1.0 / (1_u64 << DIGITS) as f64;
        for units in [0, 1, 2, 3, 1 << 61, (1 << 61) + (1 << 9), 1 << 62] {
            let time = units as f64 * unit;
            assert_eq!(Dyadic::new(time), Some(Dyadic(units)));
        }
        for time in [-unit, 0.5 * unit, 1.5 * unit, 1.0 + f64::EPSILON, f64::NAN] {
            assert_eq!(Dyadic::new(time), None, "{time}");
        }
    }

    #[test]
    fn the_shortest_time_between_two_others() {
        for low in 0..40 {
            for high in low..40 {
                let [first, last] = [low, high].map(Dyadic);
                let shortest = (low + 1..high).min_by_key(|&units| Dyadic(units).digits());
                let found = Dyadic::between(first, last);
                assert_eq!(
                    found.map(Dyadic::digits),
                    shortest.map(|units| Dyadic(units).digits())
                );
                assert!(
                    found.is_none_or(|time| time > first && time < last),
                    "{low} {high}"
                );
            }
        }
    }
}
