//! The reasons for which bodies or their motions are refused.

use exact_ccd::TimeOutOfStep;
use exact_ccd::motion::InvalidMotion;

use crate::broad_phase::TooManyPrimitives;
use crate::mesh::PositionsError;

/// Bodies or their motions are not valid.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BodiesError {
    /// The positions of a body do not fit its mesh.
    #[error("body {body}: {error}")]
    Positions {
        /// The index of the body, from 0.
        body: usize,
        /// The error.
        error: PositionsError,
    },
    /// A body is too large.
    #[error("body {body}: {error}")]
    TooManyPrimitives {
        /// The index of the body, from 0.
        body: usize,
        /// The error.
        error: TooManyPrimitives,
    },
    /// There are too many bodies.
    #[error("too many bodies: {error}")]
    TooManyBodies {
        /// The error.
        error: TooManyPrimitives,
    },
    /// There is not one motion for each body.
    #[error("{motions} motions, expected one for each of {bodies} bodies")]
    MotionCount {
        /// The number of motions.
        motions: usize,
        /// The number of bodies.
        bodies: usize,
    },
    /// There is not one pose for each body.
    #[error("{poses} poses, expected one for each of {bodies} bodies")]
    PoseCount {
        /// The number of poses.
        poses: usize,
        /// The number of bodies.
        bodies: usize,
    },
    /// Two poses of a body have no motion from one to the other.
    #[error("body {body}: {error}")]
    Motion {
        /// The index of the body, from 0.
        body: usize,
        /// The error.
        error: InvalidMotion,
    },
    /// The fraction of the time of impact to keep is out of range.
    #[error("the fraction of the time of impact to keep is {0}, expected a number above 0 and at most 1")]
    Keep(f64),
    /// The last time that counts is not in [0, 1].
    #[error(transparent)]
    Time(#[from] TimeOutOfStep),
}
