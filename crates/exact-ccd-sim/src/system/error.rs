//! Bodies that make no system.

use exact_ccd_mesh::{MeshError, Point, TetMeshError};

use crate::elasticity::ModuliError;
use crate::script::ScriptError;

/// Bodies that make no system.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SystemError {
    /// A tetrahedron or a triangle names a vertex that its body does not have.
    #[error(
        "body {body}: element {element} names vertex {vertex}, but there are only {vertex_count} vertices"
    )]
    Index {
        /// The body, from 0.
        body: usize,
        /// The element, from 0.
        element: usize,
        /// The vertex.
        vertex: u32,
        /// How many vertices the body has.
        vertex_count: usize,
    },
    /// The faces of all bodies together do not form a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// There is nothing that could touch anything.
    #[error("body {body}: there are no faces or tetrahedra, expected some")]
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
    /// The tetrahedra are no solid.
    #[error("body {body}: {source}")]
    Solid {
        /// The body, from 0.
        body: usize,
        /// What is wrong with them.
        source: TetMeshError,
    },
    /// An element has no volume or no area, up to rounding.
    #[error("body {body}: element {element} is flat, expected a positive volume or area")]
    Flat {
        /// The body, from 0.
        body: usize,
        /// The element, from 0.
        element: usize,
    },
    /// The elastic moduli are out of range.
    #[error("body {body}: {source}")]
    Moduli {
        /// The body, from 0.
        body: usize,
        /// Which modulus.
        source: ModuliError,
    },
    /// The density or the thickness is not positive.
    #[error("body {body}: the {what} is {value}, expected a positive number")]
    NotPositive {
        /// The body, from 0.
        body: usize,
        /// `density` or `thickness`.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// An element has no mass that is a normal number.
    #[error("body {body}: element {element} has a mass of {mass} kg, expected a positive number")]
    Mass {
        /// The body, from 0.
        body: usize,
        /// The element, from 0.
        element: usize,
        /// Its mass.
        mass: f64,
    },
    /// The velocity at the start is none.
    #[error("body {body}: the velocity is {velocity:?}, expected {expected}")]
    Velocity {
        /// The body, from 0.
        body: usize,
        /// Its velocity.
        velocity: Point,
        /// What it should be.
        expected: &'static str,
    },
    /// A number of a script is out of range.
    #[error("script {script}: {source}")]
    Motion {
        /// The script, from 0.
        script: usize,
        /// Which number.
        source: ScriptError,
    },
    /// A script is for vertices that there are not.
    #[error("a script moves vertex {vertex}, but there are only {vertex_count} vertices")]
    Script {
        /// The vertex.
        vertex: u32,
        /// How many vertices there are.
        vertex_count: usize,
    },
}
