//! The times at which primitives touch.

use alloc::vec::{self, Vec};
use core::ops::Deref;
use core::slice;

use super::time::ContactTime;

/// A maximal closed interval of times at which primitives touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Interval {
    /// The first time.
    pub start: ContactTime,
    /// The last time. In an interval shorter than the difference of two adjacent f64, it may compare equal
    /// to the first time.
    pub end: ContactTime,
    /// True for a single moment, false for an interval of positive length.
    pub is_moment: bool,
}

impl Interval {
    /// The interval of a single moment.
    pub(crate) fn moment(time: ContactTime) -> Self {
        Self {
            start: time,
            end: time,
            is_moment: true,
        }
    }
}

/// All times of a step at which primitives touch: the maximal closed intervals, in increasing order; a
/// slice of [`Interval`]. It is empty if they never do.
///
/// Two different intervals may begin or end between the same two adjacent f64.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Intervals(Vec<Interval>);

impl Intervals {
    /// The first time, if there is one.
    #[must_use]
    pub fn first_time(&self) -> Option<ContactTime> {
        self.0.first().map(|interval| interval.start)
    }

    /// The number of times; `None` if there are infinitely many.
    #[must_use]
    pub fn count(&self) -> Option<usize> {
        let are_moments = self.0.iter().all(|interval| interval.is_moment);
        are_moments.then_some(self.0.len())
    }
}

impl FromIterator<Interval> for Intervals {
    fn from_iter<I: IntoIterator<Item = Interval>>(intervals: I) -> Self {
        Self(intervals.into_iter().collect())
    }
}

impl Deref for Intervals {
    type Target = [Interval];

    fn deref(&self) -> &[Interval] {
        &self.0
    }
}

impl IntoIterator for Intervals {
    type Item = Interval;
    type IntoIter = vec::IntoIter<Interval>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'a> IntoIterator for &'a Intervals {
    type Item = &'a Interval;
    type IntoIter = slice::Iter<'a, Interval>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}
