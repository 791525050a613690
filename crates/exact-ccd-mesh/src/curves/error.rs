//! The reasons for which control points are refused.

use exact_ccd::TimeOutOfStep;

use crate::broad_phase::TooManyPrimitives;
use crate::mesh::PositionsError;

/// The largest number of sets of control points: degree 8.
pub(super) const MOST: usize = 9;

/// The control points of a mesh's vertices are not valid.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CurvesError {
    /// Curves have a degree that is not supported.
    #[error("{count} sets of control points; expected 2 to {MOST}, for degrees 1 to {}", MOST - 1)]
    Degree {
        /// The number of sets.
        count: usize,
    },
    /// A set of control points does not fit the mesh.
    #[error("control set {control}: {error}")]
    Positions {
        /// The index of the set, from 0.
        control: usize,
        /// The error.
        error: PositionsError,
    },
    /// The mesh is too large.
    #[error(transparent)]
    TooManyPrimitives(#[from] TooManyPrimitives),
    /// The last time that counts is not in [0, 1].
    #[error(transparent)]
    Time(#[from] TimeOutOfStep),
}
