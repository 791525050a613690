//! Errors of bodies and scripts.

use exact_ccd::InvalidThickness;
use exact_ccd_mesh::{MeshError, Point, TetMeshError};

use crate::half_space::HalfSpaceError;
use crate::range::OutOfRange;

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
    /// The sum of offsets is out of range.
    #[error(transparent)]
    Thickness(#[from] InvalidThickness),
    /// A load is out of range.
    #[error("load {load}: {source}")]
    Load {
        /// The load, from 0.
        load: usize,
        /// The number.
        source: OutOfRange,
    },
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
    /// The surface of an affine body is not closed.
    #[error(
        "body {body}: the surface of the affine body is not closed, expected each edge to be passed as often in \
         one direction as in the other one"
    )]
    Open {
        /// The body, from 0.
        body: usize,
    },
    /// A script or a load acts on some vertices of an affine body, but not on all.
    #[error(
        "{what}: {found} of the {expected} vertices of body {body} are selected, expected none or all: an affine \
         body moves as a whole"
    )]
    Partly {
        /// The script or the load.
        what: String,
        /// The body, from 0.
        body: usize,
        /// The number of selected vertices.
        found: usize,
        /// The number of vertices of the body.
        expected: usize,
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
    #[error(
        "spring {spring}: {at:?} is no vertex of body {body}, which is not affine, expected one as {nearest:?}"
    )]
    SpringEnd {
        /// The spring, from 0.
        spring: usize,
        /// The body, from 0.
        body: usize,
        /// The position of the end.
        at: Point,
        /// The nearest vertex of the body. `None` if there is no such body.
        nearest: Option<Point>,
    },
    /// Two edges of a rod return along each other.
    #[error("body {body}: the rod is folded onto itself at an end of edge {element}, expected an angle")]
    Folded {
        /// The body, from 0.
        body: usize,
        /// The first of the two edges, from 0.
        element: usize,
    },
    /// A parameter of a body is out of range.
    #[error("body {body}: {source}")]
    Body {
        /// The body, from 0.
        body: usize,
        /// The parameter.
        source: OutOfRange,
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
    #[error("body {body}: {source}, in region {region}")]
    Material {
        /// The body, from 0.
        body: usize,
        /// The region, from 0.
        region: usize,
        /// The parameter.
        source: OutOfRange,
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
