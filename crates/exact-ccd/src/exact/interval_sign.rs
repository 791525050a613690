//! Signs of all values of a polynomial in an interval of times, where they are easily proved.

use core::cmp::Ordering;

use dashu_int::IBig;

use super::approximation::Approximation;
use super::evaluation::LEAST_PRECISION;
use super::polynomial::Polynomial;
use super::split::Split;

impl Polynomial {
    /// The sign of all values in [low, high], low < high, if it is one that is easily proved: by the signs
    /// of the coefficients, or by approximations of all values.
    pub(crate) fn sign_between(&self, low: &Split, high: &Split) -> Option<Ordering> {
        if Split::closeness(low, high) == 0 {
            self.sign_everywhere()
        } else {
            self.values_between(low, high).sign()
        }
    }

    /// All values in [low, high], two times that are not far apart, by approximations, the last of which
    /// takes the slope in the interval into account.
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

    /// All values of the polynomial in τ that differ from that at t by less than 2ᵏ. The value there is as
    /// precise as that.
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

    /// The sign of all values in [0, 1], if all coefficients have it or are zero, the first and the last
    /// not.
    fn sign_everywhere(&self) -> Option<Ordering> {
        let sign = |c: &IBig| c.cmp(&IBig::ZERO);
        let [first, .., last] = self.coefficients() else {
            return self.coefficients().first().map(sign);
        };
        let at_start = sign(first);
        let agrees = |c: &IBig| sign(c) != at_start.reverse();
        (at_start.is_ne() && sign(last) == at_start && self.coefficients().iter().all(agrees))
            .then_some(at_start)
    }
}
