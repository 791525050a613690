//! The answers: floating-point filters first, then the exact path.

use alloc::vec::Vec;

use super::{DistanceBounds, Separation, SeparationStage, TimeInterval, TimeOutOfStep, filter};
use crate::collision::Collision;
use crate::exact::separation as exact;
use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::time::{ContactTime, ContactTimes};

impl<K: Kind> Query<K> {
    /// Returns true if the distance of the primitives is at most d at some time of the step.
    #[must_use]
    #[inline]
    pub fn comes_within(&self, d: Separation) -> bool {
        if d.is_zero() {
            return self.collides();
        }
        filter::first_within(self, d)
            .map_or_else(|| exact::comes_within(self, d), |(first, _)| first.is_some())
    }

    /// The collision, if the distance of the primitives is at most d at some time of the step:
    /// [`first_within`](Self::first_within), from which all further answers follow.
    #[must_use]
    #[inline]
    pub fn collision_within(&self, d: Separation) -> Option<Collision<'_, K>> {
        if d.is_zero() {
            return self.collision();
        }
        let first = self.first_within(d)?;
        Some(Collision::within(self, d, first))
    }

    /// [`collision_within`](Self::collision_within) of a query whose primitives are known to be beyond
    /// d before the first of two times. A collision after the second time, which is above 0, may be left out.
    pub(crate) fn collision_between(&self, d: Separation, times: [f64; 2]) -> Option<Collision<'_, K>> {
        if d.is_zero() {
            return self.collision();
        }
        let first = match filter::first_between(self, d, times) {
            Some((first, _)) => first,
            None => exact::first_within(self, d),
        };
        Some(Collision::within(self, d, first?))
    }

    /// The first time at which the distance of the primitives is at most d, if there is one.
    #[must_use]
    #[inline]
    pub fn first_within(&self, d: Separation) -> Option<ContactTime> {
        self.first_within_with_stage(d).0
    }

    /// [`first_within`](Self::first_within), and the stage that settled it.
    #[must_use]
    #[inline]
    pub fn first_within_with_stage(&self, d: Separation) -> (Option<ContactTime>, SeparationStage) {
        K::first_within(self, d)
    }

    /// The largest f64 not above the first time at which the distance of the primitives is at most
    /// d, if there is one.
    #[must_use]
    pub fn time_within(&self, d: Separation) -> Option<f64> {
        self.first_within(d).map(ContactTime::lower)
    }

    /// The times at which the distance of the primitives is at most d: the maximal closed
    /// intervals, in increasing order.
    ///
    /// An interval has length 0 where the primitives only reach the distance d, as at the contact
    /// of two that cross if d = 0.
    #[must_use]
    pub fn intervals_within(&self, d: Separation) -> Vec<TimeInterval> {
        if d.is_zero()
            && let ContactTimes::Finite(times) = self.contact_times()
        {
            return times.iter().copied().map(TimeInterval::moment).collect();
        }
        if let Some((None, _)) = filter::first_within(self, d) {
            return Vec::new();
        }
        exact::intervals_within(self, d)
    }

    /// The first time at which the distance of the primitives is at most d, with the closest points
    /// then.
    ///
    /// The parameters are those of the closest points, the normal is the direction from the closest
    /// point of the second primitive to that of the first; there is none if the two coincide. Where
    /// several pairs of points are the closest, it is one of them. For d = 0 this is
    /// [`impact`](Self::impact).
    #[must_use]
    pub fn impact_within(&self, d: Separation) -> Option<Impact> {
        if d.is_zero() {
            return self.impact();
        }
        match filter::first_within(self, d) {
            Some((first, _)) => exact::impact_at(self, d, first?),
            None => exact::impact_within(self, d),
        }
    }

    /// The distance of the primitives at time `t`, between two adjacent f64 or exactly.
    ///
    /// # Errors
    /// [`TimeOutOfStep`], if `t` is not in [0, 1].
    pub fn distance_at(&self, t: f64) -> Result<DistanceBounds, TimeOutOfStep> {
        exact::distance_at(self, t)
    }
}

/// The first time within d, and the stage that settled it.
pub(crate) fn first_within<K: Kind>(
    query: &Query<K>,
    d: Separation,
) -> (Option<ContactTime>, SeparationStage) {
    if d.is_zero() {
        let first = query.collision().map(|collision| collision.first_contact_time());
        return (first, SeparationStage::Contact);
    }
    filter::first_within(query, d).unwrap_or_else(|| (exact::first_within(query, d), SeparationStage::Exact))
}
