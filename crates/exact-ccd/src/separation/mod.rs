//! Minimum separation: the times at which two primitives are at most a distance d apart.

mod answers;
mod distance;
mod filter;
mod stage;

pub use distance::{DistanceBounds, InvalidSeparation, Separation, TimeOutOfStep};
pub use stage::SeparationStage;

use crate::time::ContactTime;

/// A closed interval of times, which may have length 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeInterval {
    /// The first time.
    pub start: ContactTime,
    /// The last time; equal to `start` for a single moment.
    pub end: ContactTime,
}
