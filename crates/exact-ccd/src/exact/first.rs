//! The first time at which the primitives touch, at any distance.

use alloc::boxed::Box;

use super::first_contact::FirstContact;
use super::nearness::{FirstWithin, comes_within};
use super::points::MovingPoints;
use crate::tables::{Points, Tables};
use crate::values::{ContactTime, Impact, Intervals, Separation};

/// The first contact, or the first time within a separation above 0; with the polynomials from which all
/// answers follow.
#[derive(Clone, Debug)]
pub(crate) enum First<K> {
    Contact(Box<FirstContact<K>>),
    Within(Box<FirstWithin>),
}

impl<K: Tables> First<K> {
    /// The first time at which the primitives of straight motion touch, if they do.
    pub(crate) fn of(points: &Points<f64>, separation: Separation) -> Option<Self> {
        Self::along(MovingPoints::along(points), separation)
    }

    /// The first time at which the primitives touch, if they do.
    pub(crate) fn along(points: MovingPoints, separation: Separation) -> Option<Self> {
        Some(if separation.is_zero() {
            Self::Contact(Box::new(FirstContact::along(points)?))
        } else {
            Self::Within(Box::new(FirstWithin::along::<K>(&points, separation)?))
        })
    }

    /// Returns true if the primitives of straight motion touch at some time of the step.
    pub(crate) fn exists(points: &Points<f64>, separation: Separation) -> bool {
        Self::exists_along(MovingPoints::along(points), separation)
    }

    /// Returns true if the primitives touch at some time of the step.
    pub(crate) fn exists_along(points: MovingPoints, separation: Separation) -> bool {
        if separation.is_zero() {
            FirstContact::<K>::along(points).is_some()
        } else {
            comes_within::<K>(&points, separation)
        }
    }

    /// The same if it is not after the last time that counts.
    pub(crate) fn until(self, until: f64) -> Option<Self> {
        (until >= 1.0 || self.time().is_at_most(until)).then_some(self)
    }

    pub(crate) fn time(&self) -> ContactTime {
        match self {
            Self::Contact(first) => first.time(),
            Self::Within(first) => first.time(),
        }
    }

    /// All times at which the primitives touch.
    pub(crate) fn intervals(&self) -> Intervals {
        match self {
            Self::Contact(first) => first.intervals(),
            Self::Within(first) => first.intervals(),
        }
    }

    /// The closest points at the first time.
    pub(crate) fn impact(&self) -> Impact {
        match self {
            Self::Contact(first) => first.impact(),
            Self::Within(first) => first.impact::<K>(),
        }
    }
}
