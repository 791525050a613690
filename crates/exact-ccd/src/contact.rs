//! The answers: floating-point filters first, then the exact path.

use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::time::{ContactTime, ContactTimes};
use crate::{exact, filter};

/// Where a query was settled, from the cheapest stage to the costliest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Stage {
    /// The bounding box of F at the corners of its domain leaves out the origin.
    BoundingBox,
    /// A plane through the origin and an axis, at 45° to the other two, separates.
    Diagonals,
    /// The normal of the primitives' plane at t = 0 or t = 1 separates.
    Normals,
    /// The coplanarity cubic has no root in the step.
    Coplanarity,
    /// The roots of the coplanarity cubic, and the position of the primitives at each.
    Roots,
    /// Vertices in one place, or all points on one line along an axis: comparisons prove contact.
    Coincident,
    /// A direction found by iteration separates.
    Direction,
    /// All points move in one plane across an axis, and the sides of the edges' lines on which the vertices are decide.
    Planar,
    /// The filters do not know: [`exact`](crate::exact).
    Exact,
}

impl Stage {
    /// All stages, in order.
    pub const ALL: [Self; 9] = [
        Self::BoundingBox,
        Self::Diagonals,
        Self::Normals,
        Self::Coplanarity,
        Self::Roots,
        Self::Coincident,
        Self::Direction,
        Self::Planar,
        Self::Exact,
    ];
}

impl<K: Kind> Query<K> {
    /// Whether the primitives touch at some time of the step.
    #[must_use]
    #[inline]
    pub fn collides(&self) -> bool {
        self.collides_with_stage().0
    }

    /// [`collides`](Self::collides), and the stage that settled it.
    #[must_use]
    #[inline]
    pub fn collides_with_stage(&self) -> (bool, Stage) {
        filter::collides(self).unwrap_or_else(|| (exact::collides(self), Stage::Exact))
    }

    /// All times at which the primitives touch.
    #[must_use]
    pub fn contact_times(&self) -> ContactTimes {
        self.contact_times_with_stage().0
    }

    /// [`contact_times`](Self::contact_times), and the stage that settled it.
    #[must_use]
    pub fn contact_times_with_stage(&self) -> (ContactTimes, Stage) {
        filter::contact_times(self).unwrap_or_else(|| (exact::contact_times(self), Stage::Exact))
    }

    /// The largest f64 not above the earliest contact time, if there is one.
    #[must_use]
    pub fn time_of_impact(&self) -> Option<f64> {
        self.contact_times().first().map(ContactTime::lower)
    }

    /// The earliest contact, if there is one: when, where, and its normal.
    #[must_use]
    pub fn impact(&self) -> Option<Impact> {
        filter::impact(self).unwrap_or_else(|| exact::impact(self))
    }
}
