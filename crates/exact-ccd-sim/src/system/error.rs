//! Errors of bodies, scripts, loads, springs and half spaces.

use exact_ccd::InvalidThickness;
use exact_ccd_mesh::{MeshError, Point};

use super::body_error::BodyError;
use super::designation::Designation;
use crate::half_space::HalfSpaceError;
use crate::range::OutOfRange;

/// An invalid part of a system. Bodies and half spaces have their names.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SystemError {
    /// A body is invalid.
    #[error("{body}: {source}")]
    Body {
        /// The body.
        body: Designation,
        /// The cause.
        source: BodyError,
    },
    /// The faces of all bodies together do not form a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The sum of offsets is out of range.
    #[error(transparent)]
    Thickness(#[from] InvalidThickness),
    /// A half space is invalid.
    #[error("{half_space}: the {} is {:?}, expected {}", source.what, source.value, source.expected)]
    HalfSpace {
        /// The half space.
        half_space: Designation,
        /// The cause.
        source: HalfSpaceError,
    },
    /// A load is out of range.
    #[error("load {load}: {source}")]
    Load {
        /// The load, from 0.
        load: usize,
        /// The number.
        source: OutOfRange,
    },
    /// A spring is out of range.
    #[error("spring {spring}: {source}")]
    Spring {
        /// The spring, from 0.
        spring: usize,
        /// The number.
        source: OutOfRange,
    },
    /// An end of a spring is at no vertex of its body.
    #[error("spring {spring}: {}", expected_end(body, at, *nearest))]
    SpringEnd {
        /// The spring, from 0.
        spring: usize,
        /// The body.
        body: Designation,
        /// The position of the end.
        at: Point,
        /// The nearest vertex of the body. `None` if there is no such body.
        nearest: Option<Point>,
    },
    /// A parameter of a script is out of range.
    #[error("script {script}: {source}")]
    Motion {
        /// The script, from 0.
        script: usize,
        /// The parameter.
        source: OutOfRange,
    },
    /// A script has a vertex index that is out of range.
    #[error(
        "script {script}: the vertex index {vertex} is out of range, expected an index below {vertex_count}"
    )]
    Script {
        /// The script, from 0.
        script: usize,
        /// The vertex.
        vertex: u32,
        /// The number of vertices of the system.
        vertex_count: usize,
    },
}

/// The end of a spring that is at no vertex, and the vertex that may be meant.
fn expected_end(body: &Designation, at: &Point, nearest: Option<Point>) -> String {
    match nearest {
        Some(nearest) => {
            format!(
                "{at:?} is no vertex of {body}, which is not affine, expected one as {nearest:?}, the nearest one"
            )
        }
        None => format!("there is no {body}, expected one of the bodies of the system"),
    }
}
