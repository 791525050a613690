//! Errors of bodies, scripts, loads, springs and half spaces.

use exact_ccd::InvalidThickness;
use exact_ccd_mesh::{HalfSpaceError, MeshError};

use super::body_error::BodyError;
use super::designation::Designation;
use super::spring_error::SpringError;
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
    /// A half space has a point that is not finite, or no normal.
    #[error("{half_space}: {source}")]
    HalfSpace {
        /// The half space.
        half_space: Designation,
        /// The point or the normal.
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
    /// A spring is invalid.
    #[error("spring {spring}: {source}")]
    Spring {
        /// The spring, from 0.
        spring: usize,
        /// The cause.
        source: SpringError,
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
