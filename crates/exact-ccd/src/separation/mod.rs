//! Minimum separation: the times at which two primitives are at most a distance d apart.
//!
//! The distance is that of the closed primitives, d is taken exactly, and the answers are exact for
//! every finite input. [`Query::comes_within`](crate::Query::comes_within) decides,
//! [`Query::time_within`](crate::Query::time_within) is the first time, rounded down to f64,
//! [`Query::intervals_within`](crate::Query::intervals_within) all of them. The integers of
//! [`exact::separation`](crate::exact::separation) define the answers; filters answer first where
//! they prove the same.
//!
//! ```
//! use exact_ccd::separation::Separation;
//! use exact_ccd::{Query, VertexEdge};
//!
//! // A vertex passes an edge at rest at the distance 3.
//! let (a, b) = ([-9.0, 0.0, 0.0], [9.0, 0.0, 0.0]);
//! let query = Query::<VertexEdge>::new([[0.0, 3.0, -8.0], a, b], [[0.0, 3.0, 8.0], a, b])?;
//! let d = Separation::new(5.0)?;
//! assert!(query.comes_within(d));
//! assert_eq!(query.time_within(d), Some(0.25));
//! assert_eq!(query.intervals_within(d)[0].end.lower(), 0.75);
//! assert_eq!(query.distance_at(0.5)?.lower, 3.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod answers;
mod distance;
mod filter;
mod stage;
mod thickness;

pub(crate) use answers::first_within;
pub use distance::{DistanceBounds, InvalidSeparation, Separation, TimeOutOfStep};
pub(crate) use filter::Screening;
pub use stage::SeparationStage;
pub use thickness::{InvalidThickness, Separations, Thickness};

use crate::time::ContactTime;

/// A closed interval of times, which may have length 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeInterval {
    /// The first time.
    pub start: ContactTime,
    /// The last time. It is equal to `start` for a single moment, and may be for an interval shorter
    /// than the difference of two f64.
    pub end: ContactTime,
}

impl TimeInterval {
    /// The interval of length 0 at a time.
    pub(crate) fn moment(time: ContactTime) -> Self {
        Self {
            start: time,
            end: time,
        }
    }
}
