//! Errors of line searches.

use crate::mesh::PositionsError;
use crate::steps::StepError;

/// The reason why a line search has no result.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LineSearchError {
    /// The positions at the start, or at the end of the full step, do not fit the mesh.
    #[error(transparent)]
    Step(#[from] StepError),
    /// The direction does not fit the mesh.
    #[error("in the direction, {0}")]
    Direction(#[source] PositionsError),
    /// The fraction of the time of impact to keep is out of range.
    #[error("the fraction of the time of impact to keep is {0}, expected a number above 0 and at most 1")]
    Keep(f64),
    /// A position at the start is not in the precision of the options.
    #[error(
        "vertex {vertex} at the start is not in single precision, but the end is to be: round all positions \
         before the first step"
    )]
    Precision {
        /// The first such vertex.
        vertex: usize,
    },
    /// A pinned vertex is not one of the mesh.
    #[error("vertex {vertex} is pinned, but the mesh has {vertex_count} vertices")]
    Pinned {
        /// The index of the vertex.
        vertex: u32,
        /// The number of vertices of the mesh.
        vertex_count: usize,
    },
    /// The caller has cancelled the search.
    #[error("the search for a free step was cancelled")]
    Cancelled,
}
