//! The answer of a step of a mesh, its options and its errors.

use exact_ccd::{InvalidThickness, Thickness};
use exact_ccd_mesh::{CanCollide, Pair, StepError};

use crate::answer::Answer;
use crate::error::SearchError;
use crate::options::SearchOptions;

/// The certified part of a step of a mesh whose vertices move on curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvedStep {
    /// The pair whose certainly free time ends first, if a pair is not free.
    pub pair: Option<Pair>,
    /// The answer for that pair: all pairs are certainly farther than d apart before
    /// [`free_until`](Answer::free_until), and until the last time that counts if it [is
    /// free](Answer::is_free). The number of chords is the sum over all pairs.
    pub answer: Answer,
    /// The number of intervals of time with a broad phase of their own.
    pub intervals: usize,
    /// The number of pairs that the broad phases found.
    pub candidates: usize,
}

/// The reason why a step has no answer.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CurvedStepError {
    /// The positions at the ends of an interval are not a step of the mesh.
    #[error("for the times from {start} to {end}: {source}")]
    Step {
        /// The start of the interval.
        start: f64,
        /// The end of the interval.
        end: f64,
        /// The reason.
        source: StepError,
    },
    /// The deviation of a vertex, and half of d, are too large.
    #[error(
        "for the times from {start} to {end}, the deviation of vertex {} with half of the distance is {}, \
         expected at most {:e}",
        .source.vertex, .source.value, Thickness::MAX
    )]
    Deviation {
        /// The start of the interval.
        start: f64,
        /// The end of the interval.
        end: f64,
        /// The vertex.
        source: InvalidThickness,
    },
    /// A bound of a trajectory is not valid, and its point is the index of the vertex; or an option is
    /// not valid; or a thread has another environment.
    #[error(transparent)]
    Search(#[from] SearchError),
    /// The search of a pair failed; the message numbers the points within the pair.
    #[error("{pair:?}: {source}")]
    Pair {
        /// The pair.
        pair: Pair,
        /// The reason.
        source: SearchError,
    },
}

/// Options of [`curved_step`](crate::curved_step).
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct CurvedStepOptions {
    /// The end of the search of each pair.
    pub search: SearchOptions,
    /// The pairs that can collide. For rigid bodies, use
    /// [`Instances::can_collide`](crate::Instances::can_collide).
    pub can_collide: CanCollide,
}

impl CurvedStepOptions {
    /// The same options with other options of the searches.
    #[must_use]
    pub fn with_search(self, search: SearchOptions) -> Self {
        Self { search, ..self }
    }

    /// The same options with another predicate.
    #[must_use]
    pub fn with_can_collide(self, can_collide: CanCollide) -> Self {
        Self { can_collide, ..self }
    }
}
