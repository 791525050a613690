//! Errors of bodies and scripts.

use exact_ccd::{InvalidThickness, Thickness};
use exact_ccd_mesh::{MeshError, Point, TetMeshError};

use crate::elasticity::ModuliError;
use crate::half_space::HalfSpaceError;
use crate::load::LoadError;
use crate::script::ScriptError;

/// An invalid body or script.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SystemError {
    /// A tetrahedron, a triangle or an edge has a vertex index that is out of range.
    #[error(
        "body {body}: element {element} has the vertex index {vertex}, expected an index below {vertex_count}"
    )]
    Index {
        /// The body, from 0.
        body: usize,
        /// The element, from 0.
        element: usize,
        /// The vertex.
        vertex: u32,
        /// The number of vertices of the body.
        vertex_count: usize,
    },
    /// The faces of all bodies together do not form a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// An offset is out of range. [`SystemError::Offset`] names the body instead.
    #[error(transparent)]
    Thickness(#[from] InvalidThickness),
    /// A load is out of range.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// A half space is invalid.
    #[error(transparent)]
    HalfSpace(#[from] HalfSpaceError),
    /// A body has no elements.
    #[error("body {body}: the mesh is empty, expected at least one element")]
    Empty {
        /// The body, from 0.
        body: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("body {body}: vertex {vertex} is at {position:?}, expected finite numbers")]
    NotFinite {
        /// The body, from 0.
        body: usize,
        /// The vertex, from 0.
        vertex: usize,
        /// Its position.
        position: Point,
    },
    /// The tetrahedra are not a valid mesh.
    #[error("body {body}: {source}")]
    Solid {
        /// The body, from 0.
        body: usize,
        /// The cause.
        source: TetMeshError,
    },
    /// An element has no volume, no area or no length, up to rounding.
    #[error("body {body}: element {element} is flat, expected a positive volume, area or length")]
    Flat {
        /// The body, from 0.
        body: usize,
        /// The element, from 0.
        element: usize,
    },
    /// Two edges of a rod return along each other.
    #[error("body {body}: the rod is folded onto itself at an end of edge {element}, expected an angle")]
    Folded {
        /// The body, from 0.
        body: usize,
        /// The first of the two edges, from 0.
        element: usize,
    },
    /// An elastic modulus is out of range.
    #[error("body {body}: {source}")]
    Moduli {
        /// The body, from 0.
        body: usize,
        /// The modulus and its value.
        source: ModuliError,
    },
    /// The density, the thickness or the radius is not positive.
    #[error("body {body}: the {what} is {value}, expected a positive finite number")]
    NotPositive {
        /// The body, from 0.
        body: usize,
        /// `density`, `thickness` or `radius`.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A region of a solid has a tetrahedron that the solid does not have.
    #[error("body {body}: region {region} has tetrahedron {element}, expected a number below {count}")]
    Region {
        /// The body, from 0.
        body: usize,
        /// The region, from 0.
        region: usize,
        /// The tetrahedron.
        element: u32,
        /// The number of tetrahedra of the solid.
        count: usize,
    },
    /// The material of a region of a solid is out of range.
    #[error("{source}, in region {region}")]
    InRegion {
        /// The region, from 0.
        region: usize,
        /// The error of the material.
        source: Box<SystemError>,
    },
    /// The offset of the contact surface is out of range.
    #[error(
        "body {body}: the offset is {offset}, expected a number from 0 to {:e}",
        Thickness::MAX
    )]
    Offset {
        /// The body, from 0.
        body: usize,
        /// Its offset.
        offset: f64,
    },
    /// The mass of an element is not a normal number.
    #[error("body {body}: element {element} has a mass of {mass} kg, expected a positive normal number")]
    Mass {
        /// The body, from 0.
        body: usize,
        /// The element, from 0.
        element: usize,
        /// Its mass.
        mass: f64,
    },
    /// A velocity at the start is not finite, or an obstacle has one.
    #[error("body {body}: the {what} is {velocity:?}, expected {expected}")]
    Velocity {
        /// The body, from 0.
        body: usize,
        /// `velocity` or `angular velocity`.
        what: &'static str,
        /// Its value.
        velocity: Point,
        /// The velocities that are allowed.
        expected: &'static str,
    },
    /// A parameter of a script is out of range.
    #[error("script {script}: {source}")]
    Motion {
        /// The script, from 0.
        script: usize,
        /// The parameter.
        source: ScriptError,
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

/// Checks that a parameter of a body is positive and finite.
pub(super) fn positive(body: usize, what: &'static str, value: f64) -> Result<(), SystemError> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(SystemError::NotPositive { body, what, value })
    }
}
