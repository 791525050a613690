//! Errors of one spring.

use exact_ccd_mesh::Point;

use super::designation::Designation;
use crate::range::OutOfRange;

/// An invalid spring. [`SystemError::Spring`](crate::SystemError::Spring) has its number.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SpringError {
    /// A parameter is out of range.
    #[error(transparent)]
    Parameter(#[from] OutOfRange),
    /// An end names a body that does not exist.
    #[error("there is no {body}, expected one of the bodies of the system")]
    Body {
        /// The body.
        body: Designation,
    },
    /// An end is at no vertex of its body.
    #[error(
        "{at:?} is no vertex of {body}, which is not affine, expected one as {nearest:?}, the nearest one"
    )]
    End {
        /// The body.
        body: Designation,
        /// The position of the end.
        at: Point,
        /// The nearest vertex of the body.
        nearest: Point,
    },
}
