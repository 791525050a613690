//! The answers: floating-point filters first, then the exact path.

use crate::exact;
use crate::kind::Kind;
use crate::query::{Point, Query};
use crate::time::{ContactTime, ContactTimes};

/// The earliest contact of a query.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    /// When.
    pub time: ContactTime,
    /// Where on the primitives: (u, v).
    pub parameters: [f64; 2],
    /// The unit contact normal.
    pub normal: Option<Point>,
}

impl<K: Kind> Query<K> {
    /// Whether the primitives touch at some time of the step.
    #[must_use]
    pub fn collides(&self) -> bool {
        exact::collides(self)
    }

    /// All times at which the primitives touch.
    #[must_use]
    pub fn contact_times(&self) -> ContactTimes {
        exact::contact_times(self)
    }

    /// The largest f64 not above the earliest contact time, if there is one.
    #[must_use]
    pub fn time_of_impact(&self) -> Option<f64> {
        self.contact_times().first().map(ContactTime::lower)
    }
}
