//! Errors of a repair.

use exact_ccd_mesh::{CandidateError, IntersectionsError, LineSearchError, PositionsError, StepError};

/// The reason why a repair cannot begin, or was ended by its caller.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RepairError {
    /// The positions do not fit the mesh.
    #[error(transparent)]
    Positions(#[from] PositionsError),
    /// The mesh is too large, or the minimum distance does not fit it.
    #[error(transparent)]
    Step(#[from] StepError),
    /// The mesh is too large.
    #[error(transparent)]
    Intersections(#[from] IntersectionsError),
    /// Near pairs cannot be searched.
    #[error(transparent)]
    Candidates(#[from] CandidateError),
    /// A pinned vertex is not one of the mesh.
    #[error("vertex {vertex} is pinned, but the mesh has {vertex_count} vertices")]
    Pinned {
        /// The index of the vertex.
        vertex: u32,
        /// The number of vertices of the mesh.
        vertex_count: usize,
    },
    /// A coordinate is beyond the range of `f32`.
    #[error("vertex {vertex} has a coordinate beyond the range of single precision: scale the mesh")]
    NotSingle {
        /// The index of the vertex.
        vertex: usize,
    },
    /// The positions are so large or so small that lengths are not normal numbers.
    #[error(
        "the diagonal of the box around all positions is {0:e}, expected one from 1e-140 to 1e140: scale the mesh"
    )]
    Size(f64),
    /// The linear system of the smoothing has no factorisation.
    #[error(
        "the linear system of {vertex_count} vertices could not be factorised: there is too little memory"
    )]
    Factorisation {
        /// The number of vertices that can move.
        vertex_count: usize,
    },
    /// The caller has cancelled the repair.
    #[error("the repair was cancelled")]
    Cancelled,
}

impl From<LineSearchError> for RepairError {
    fn from(error: LineSearchError) -> Self {
        match error {
            LineSearchError::Step(error) => Self::Step(error),
            LineSearchError::Pinned { vertex, vertex_count } => Self::Pinned { vertex, vertex_count },
            // A direction and a fraction of a step are not the caller's.
            _ => Self::Cancelled,
        }
    }
}
