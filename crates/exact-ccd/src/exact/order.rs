//! The order of times, and times between two of them.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::instant::Instant;
use super::split::Split;
use crate::time::ContactTime;

impl Instant {
    /// Inserts this time into distinct ones in increasing order, unless it is one of them.
    pub(crate) fn insert_into(self, times: &mut Vec<Self>) {
        match times.binary_search_by(|time| time.order(&self)) {
            Ok(_) => {}
            Err(index) => times.insert(index, self),
        }
    }

    fn order(&self, other: &Self) -> Ordering {
        if self.equals(other) {
            return Ordering::Equal;
        }
        let (this, other) = self.apart(other);
        this.bounds().1.cmp(other.bounds().0)
    }

    /// Returns true if this time is another one.
    fn equals(&self, other: &Self) -> bool {
        match (self, other) {
            (_, Self::At(t)) => self.compare(t).is_eq(),
            (Self::At(t), _) => other.compare(t).is_eq(),
            // A common root of both polynomials in both brackets, which have no other roots there.
            (Self::Root(one), Self::Root(two)) => {
                one.low() < two.high()
                    && two.low() < one.high()
                    && one.is_root_of(&two.of)
                    && one.compare(two.low()).is_gt()
                    && one.compare(two.high()).is_lt()
            }
        }
    }

    /// This time and another one in disjoint closed brackets. The times must be different.
    fn apart(&self, other: &Self) -> (Self, Self) {
        let (mut this, mut other) = (self.clone(), other.clone());
        while this.bounds().1 >= other.bounds().0 && other.bounds().1 >= this.bounds().0 {
            if this.closeness() < other.closeness() {
                this = this.narrowed();
            } else {
                other = other.narrowed();
            }
        }
        (this, other)
    }

    /// A number strictly between this time and a later one.
    pub(crate) fn before(&self, later: &Self) -> Split {
        let (this, later) = self.apart(later);
        Split::between(this.bounds().1, later.bounds().0)
    }

    /// The time as an f64 or between two adjacent ones, by bisection over bit patterns, which are
    /// ordered like the numbers.
    pub(crate) fn round(&self) -> ContactTime {
        let (mut low, mut high) = (0.0f64.to_bits(), 1.0f64.to_bits() + 1);
        let compare = |bits| self.compare(&Split::from_unit(f64::from_bits(bits)));
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if compare(middle).is_ge() {
                low = middle;
            } else {
                high = middle;
            }
        }
        let floor = f64::from_bits(low);
        if compare(low).is_eq() {
            ContactTime::exactly(floor)
        } else {
            ContactTime::just_above(floor)
        }
    }
}
