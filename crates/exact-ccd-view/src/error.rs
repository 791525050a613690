//! Errors of pages.

use exact_ccd_mesh::{Intersection, Pair, PositionsError};

/// The reason why data is not shown on a page.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PageError {
    /// The positions of a frame do not fit the mesh.
    #[error("in frame {frame}, {source}")]
    Positions {
        /// The index of the frame on the page, from 0.
        frame: usize,
        /// The reason.
        source: PositionsError,
    },
    /// A contact was added before the first frame.
    #[error("the page has no frames, expected the frames of a contact before the contact")]
    NoFrame,
    /// The primitives of a contact are not primitives of the mesh.
    #[error("{pair:?} is not a pair of this mesh, expected a contact of the last step of the page")]
    NoSuchPair {
        /// The primitives.
        pair: Pair,
    },
    /// The primitives of an intersection are not primitives of the mesh.
    #[error("{intersection:?} is not of this mesh, expected an intersection in the last frame of the page")]
    NoSuchIntersection {
        /// The primitives.
        intersection: Intersection,
    },
    /// A vertex or a half space of a contact between them is not on the page.
    #[error(
        "the page has no vertex {vertex} or no half space {half_space}, expected a vertex of the mesh and the number \
         of a half space that was added before"
    )]
    NoSuchHalfSpace {
        /// The vertex.
        vertex: u32,
        /// The number of the half space, from 0.
        half_space: u32,
    },
}
