//! All values of a polynomial in an interval of times.

use super::approximation::Approximation;
use super::evaluation::LEAST_PRECISION;
use super::polynomial::Polynomial;
use super::split::Split;

impl Polynomial {
    /// All values in [low, high], two times that are not far apart, by approximations. The last one takes the
    /// slope in the interval into account.
    ///
    /// Around a number at which the polynomial does not vanish, all values in a narrow bracket have a
    /// sign: the error of each approximation is then proportional to the width.
    pub(super) fn values_between(&self, low: &Split, high: &Split) -> Approximation {
        let closeness = Split::closeness(low, high);
        let mut precision = LEAST_PRECISION;
        while precision < closeness {
            let values = self.values(low, high, precision);
            if values.sign().is_some() {
                return values;
            }
            precision *= 4;
        }
        self.values_near(&self.slope(), low, high)
    }

    /// All values in [low, high], two times that are not far apart, by the value at `low` and the largest
    /// magnitude of the slope, which is given.
    pub(super) fn values_near(&self, slope: &Self, low: &Split, high: &Split) -> Approximation {
        let closeness = Split::closeness(low, high);
        let change = slope.bound_near(low, high, closeness) + high.top() - closeness as isize;
        self.changed_by(change, low)
    }

    /// All values of the polynomial in τ that differ from its value at t by less than 2ᵏ. The value at t is
    /// computed to this precision.
    fn changed_by(&self, change: isize, t: &Split) -> Approximation {
        let value = self.values(t, t, self.precision_of(change - 12, t.top()));
        let change = (change - value.unit).max(0).unsigned_abs();
        Approximation {
            error: value.error.map(|error| error.max(change) + 1),
            ..value
        }
    }

    /// A k such that all magnitudes in [low, high] are less than 2ᵏ, as small as the width allows, or not
    /// much above one of them.
    fn bound_near(&self, low: &Split, high: &Split, closeness: usize) -> isize {
        let mut precision = LEAST_PRECISION;
        loop {
            let values = self.values(low, high, precision);
            if values.is_known_to(0) || precision > closeness {
                return values.bound();
            }
            precision = (4 * precision).min(LEAST_PRECISION + closeness);
        }
    }
}
