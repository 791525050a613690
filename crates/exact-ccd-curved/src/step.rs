//! A step of a mesh whose vertices move on curves.

use exact_ccd::separation::{InvalidThickness, Separation};
use exact_ccd_mesh::{CanCollide, Pair, StepError, TriangleMesh};

use crate::answer::{Answer, End};
use crate::error::SearchError;
use crate::interval::Interval;
use crate::options::SearchOptions;
use crate::rounding::flushes_subnormals;
use crate::trajectory::Trajectory;

/// The certified part of a step of a mesh whose vertices move on curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvedStep {
    /// The pair with the earliest time until which it is certainly free, if a pair is not free.
    pub pair: Option<Pair>,
    /// The answer for that pair: all pairs are certainly farther than d apart before
    /// [`free_until`](Answer::free_until), and in the whole step if it [is free](Answer::is_free). The
    /// number of chords is that of all pairs.
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
    #[error("for the times from {start} to {end}: {source}")]
    Deviation {
        /// The start of the interval.
        start: f64,
        /// The end of the interval.
        end: f64,
        /// The vertex.
        source: InvalidThickness,
    },
    /// A bound of a trajectory is not valid, and its point is the index of the vertex; or an option is
    /// not valid.
    #[error(transparent)]
    Search(#[from] SearchError),
    /// The search of a pair failed: the points are those of the pair.
    #[error("{pair:?}: {source}")]
    Pair {
        /// The pair.
        pair: Pair,
        /// The reason.
        source: SearchError,
    },
}

/// Options of [`curved_step`].
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct CurvedStepOptions {
    /// The end of the search of each pair.
    pub search: SearchOptions,
    /// The pairs that can collide. For rigid bodies, those of
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

/// The first time at which two primitives of a mesh, whose vertices move on curves, are at most d
/// apart, between certain bounds.
///
/// The step is cut into intervals of time in which the deviations are small compared with the motion. In
/// each, every vertex moves along its chord and is as thick as its deviation and d / 2. The pairs that
/// come within the sum of their thicknesses are searched as by [`first_within`](crate::first_within), those
/// with the earliest chords first, until no other can be earlier. Primitives that share a vertex are left
/// out. The result does not depend on the number of threads.
///
/// # Errors
/// [`CurvedStepError`], if the trajectories are not as many as the vertices, if a position is not finite,
/// or if a bound or the tolerance is not valid.
pub fn curved_step<T: Trajectory + Sync>(
    mesh: &TriangleMesh,
    trajectories: &[T],
    d: Separation,
    options: &CurvedStepOptions,
) -> Result<CurvedStep, CurvedStepError> {
    options.search.check()?;
    if flushes_subnormals() {
        return Err(SearchError::FlushedSubnormals.into());
    }
    let answer = Answer {
        free_until: 0.0,
        within: None,
        end: End::Free,
        chords: 0,
    };
    let mut step = CurvedStep {
        pair: None,
        answer,
        intervals: 0,
        candidates: 0,
    };
    let mut ends = vec![1.0];
    while let (Some(&end), None) = (ends.last(), step.pair) {
        let start = step.answer.free_until;
        let interval = Interval::new(mesh, trajectories, start, end)?;
        if interval.is_coarse() {
            ends.push(start + 0.5 * (end - start));
            continue;
        }
        ends.pop();
        step.intervals += 1;
        interval.advance(d, options, &mut step)?;
    }
    Ok(step)
}
