//! The order of times.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::instant::Instant;
use super::split::Split;
use crate::values::ContactTime;

impl Instant {
    /// Inserts this time into distinct ones in increasing order, unless it is one of them.
    pub(crate) fn insert_into(mut self, times: &mut Vec<Self>) {
        let mut index = 0;
        while let Some(time) = times.get_mut(index) {
            match time.order(&mut self) {
                Ordering::Less => index += 1,
                Ordering::Equal => return,
                Ordering::Greater => break,
            }
        }
        times.insert(index, self);
    }

    /// The earlier one of two times.
    pub(crate) fn earlier(mut self, mut other: Self) -> Self {
        if self.order(&mut other).is_gt() {
            other
        } else {
            self
        }
    }

    /// The comparison of two times. Different times keep the disjoint brackets that it needs.
    pub(super) fn order(&mut self, other: &mut Self) -> Ordering {
        if self.equals(other) {
            return Ordering::Equal;
        }
        self.part(other);
        self.bounds().1.cmp(other.bounds().0)
    }

    /// Returns true if this time is another one.
    fn equals(&mut self, other: &Self) -> bool {
        match (self, other) {
            (this, Self::At(t)) => this.compare(t).is_eq(),
            (Self::At(t), _) => other.compare(t).is_eq(),
            // A common root of both polynomials in both brackets, which have no other roots there.
            (Self::Root(one), Self::Root(two)) => {
                one.low() < two.high()
                    && two.low() < one.high()
                    && one.is_root_of(two.polynomial())
                    && one.compare(two.low()).is_gt()
                    && one.compare(two.high()).is_lt()
            }
        }
    }

    /// Makes the brackets of two different times narrower, until they are disjoint, with their ends.
    fn part(&mut self, other: &mut Self) {
        while self.bounds().1 >= other.bounds().0 && other.bounds().1 >= self.bounds().0 {
            let wider = if self.closeness() < other.closeness() {
                &mut *self
            } else {
                &mut *other
            };
            wider.narrow(usize::MAX);
        }
    }

    /// The time as an f64 or between two adjacent ones.
    pub(crate) fn round(&self) -> ContactTime {
        let mut narrow = self.clone();
        // At most a few f64 are then in the bracket.
        narrow.narrow_to(64);
        let compare = |bits| narrow.compare(&Split::from_unit(f64::from_bits(bits)));
        let mut floor = narrow.bounds().0.floor();
        while floor < 1.0f64.to_bits() && compare(floor + 1).is_ge() {
            floor += 1;
        }
        let is_exact = compare(floor).is_eq();
        let floor = f64::from_bits(floor);
        if is_exact {
            ContactTime::exactly(floor)
        } else {
            ContactTime::just_above(floor)
        }
    }
}
