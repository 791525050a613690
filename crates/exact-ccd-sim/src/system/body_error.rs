//! Errors of one body.

use exact_ccd_mesh::{Point, TetMeshError};

use crate::range::OutOfRange;

/// An invalid body. [`SystemError::Body`](crate::SystemError::Body) has its name.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BodyError {
    /// A tetrahedron, a triangle or an edge has a vertex index that is out of range.
    #[error("element {element} has the vertex index {vertex}, expected an index below {vertex_count}")]
    Index {
        /// The element, from 0.
        element: usize,
        /// The vertex.
        vertex: u32,
        /// The number of vertices of the body.
        vertex_count: usize,
    },
    /// The body has no elements.
    #[error("the mesh is empty, expected at least one element")]
    Empty,
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} is at {position:?}, expected finite numbers")]
    NotFinite {
        /// The vertex, from 0.
        vertex: usize,
        /// Its position.
        position: Point,
    },
    /// The tetrahedra are not a valid mesh.
    #[error(transparent)]
    Solid(#[from] TetMeshError),
    /// An element has no volume, no area or no length, up to rounding.
    #[error("element {element} is flat, expected a positive volume, area or length")]
    Flat {
        /// The element, from 0.
        element: usize,
    },
    /// The surface of an affine body is not closed.
    #[error(
        "the surface of the affine body is not closed, expected each edge to be passed as often in one direction \
         as in the other one"
    )]
    Open,
    /// The surface of an affine body encloses no volume, up to rounding.
    #[error("the surface of the affine body encloses no volume, expected a positive one")]
    NoVolume,
    /// Two edges of a rod return along each other.
    #[error("the rod is folded onto itself at an end of edge {element}, expected an angle")]
    Folded {
        /// The first of the two edges, from 0.
        element: usize,
    },
    /// A parameter is out of range.
    #[error(transparent)]
    Parameter(#[from] OutOfRange),
    /// A region of a solid has a tetrahedron that the solid does not have.
    #[error("region {region} has tetrahedron {element}, expected a number below {count}")]
    Region {
        /// The region, from 0.
        region: usize,
        /// The tetrahedron.
        element: u32,
        /// The number of tetrahedra of the solid.
        count: usize,
    },
    /// The material of a region of a solid is out of range.
    #[error("{source}, in region {region}")]
    Material {
        /// The region, from 0.
        region: usize,
        /// The parameter.
        source: OutOfRange,
    },
    /// The mass of an element underflows or overflows: it is no normal floating-point number.
    #[error("element {element} has a mass of {mass} kg, expected one from about 1e-307 to 1e308 kg")]
    Mass {
        /// The element, from 0.
        element: usize,
        /// Its mass.
        mass: f64,
    },
    /// A script or a load acts on some vertices of an affine body, but not on all.
    #[error(
        "{what} selects {found} of the {expected} vertices, expected none or all: an affine body moves as a whole"
    )]
    Partly {
        /// The script or the load.
        what: Selecting,
        /// The number of selected vertices.
        found: usize,
        /// The number of vertices of the body.
        expected: usize,
    },
}

/// A script or a load, by its index in the system's list, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Selecting {
    /// A script.
    Script(usize),
    /// A load.
    Load(usize),
}

impl std::fmt::Display for Selecting {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Script(place) => write!(f, "script {place}"),
            Self::Load(place) => write!(f, "load {place}"),
        }
    }
}
