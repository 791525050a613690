//! The answers: floating-point filters first, then the exact path.

use alloc::vec::Vec;

use super::{DistanceBounds, Separation, TimeInterval, TimeOutOfStep};
use crate::exact::separation as exact;
use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::time::{ContactTime, ContactTimes};

impl<K: Kind> Query<K> {
    /// Returns true if the distance of the primitives is at most d at some time of the step.
    #[must_use]
    pub fn comes_within(&self, d: Separation) -> bool {
        if d.get() == 0.0 {
            return self.collides();
        }
        exact::comes_within(self, d)
    }

    /// The first time at which the distance of the primitives is at most d, if there is one.
    #[must_use]
    pub fn first_within(&self, d: Separation) -> Option<ContactTime> {
        if d.get() == 0.0 {
            return self.contact_times().first();
        }
        exact::first_within(self, d)
    }

    /// The largest f64 not above the first time at which the distance of the primitives is at most d, if there is one.
    #[must_use]
    pub fn time_within(&self, d: Separation) -> Option<f64> {
        self.first_within(d).map(ContactTime::lower)
    }

    /// The times at which the distance of the primitives is at most d: the maximal closed intervals, in increasing order.
    ///
    /// An interval has length 0 where the primitives only reach the distance d, as at the contact of two that cross if
    /// d = 0.
    #[must_use]
    pub fn intervals_within(&self, d: Separation) -> Vec<TimeInterval> {
        if d.get() == 0.0
            && let ContactTimes::Finite(times) = self.contact_times()
        {
            let moment = |&time: &ContactTime| TimeInterval {
                start: time,
                end: time,
            };
            return times.iter().map(moment).collect();
        }
        exact::intervals_within(self, d)
    }

    /// The first time at which the distance of the primitives is at most d, with the closest points then.
    ///
    /// The parameters are those of the closest points, the normal is the direction from the closest point of the second
    /// primitive to that of the first; there is none if the two coincide. Where several pairs of points are the closest,
    /// it is one of them. For d = 0 this is [`impact`](Self::impact).
    #[must_use]
    pub fn impact_within(&self, d: Separation) -> Option<Impact> {
        if d.get() == 0.0 {
            return self.impact();
        }
        exact::impact_within(self, d)
    }

    /// The distance of the primitives at time `t`, between two adjacent f64 or exactly.
    ///
    /// # Errors
    /// [`TimeOutOfStep`], if `t` is not in [0, 1].
    pub fn distance_at(&self, t: f64) -> Result<DistanceBounds, TimeOutOfStep> {
        exact::distance_at(self, t)
    }
}
