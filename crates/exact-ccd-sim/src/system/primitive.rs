//! Primitives of bodies in messages.

use std::fmt;

use exact_ccd_mesh::{Pair, TriangleMesh};

use super::{Designation, System};

/// A primitive of a surface, by its vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Primitive {
    /// A vertex.
    Vertex(u32),
    /// An edge.
    Edge([u32; 2]),
    /// A face.
    Face([u32; 3]),
}

impl Primitive {
    /// Its vertices.
    #[must_use]
    pub fn vertices(&self) -> &[u32] {
        match self {
            Self::Vertex(vertex) => std::slice::from_ref(vertex),
            Self::Edge(edge) => edge,
            Self::Face(face) => face,
        }
    }

    /// The two primitives of a pair of a mesh.
    pub(crate) fn of_pair(mesh: &TriangleMesh, pair: Pair) -> [Self; 2] {
        let (ids, sizes) = (pair.ids(), pair.kind().sizes());
        [0, 1].map(|i| match (ids[i], sizes[i]) {
            (vertex, 1) => Self::Vertex(vertex),
            (edge, 2) => Self::Edge(mesh.edges()[edge as usize]),
            (face, _) => Self::Face(mesh.faces()[face as usize]),
        })
    }

    /// The primitive with its vertex indices mapped by a function.
    #[must_use]
    pub fn map(self, number: impl Fn(u32) -> u32) -> Self {
        match self {
            Self::Vertex(vertex) => Self::Vertex(number(vertex)),
            Self::Edge(edge) => Self::Edge(edge.map(number)),
            Self::Face(face) => Self::Face(face.map(number)),
        }
    }
}

impl fmt::Display for Primitive {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vertex(vertex) => write!(f, "vertex {vertex}"),
            Self::Edge(edge) => write!(f, "edge {edge:?}"),
            Self::Face(face) => write!(f, "face {face:?}"),
        }
    }
}

/// A primitive of a body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BodyPrimitive {
    /// The primitive, with the vertex indices of the body.
    pub primitive: Primitive,
    /// The body.
    pub body: Designation,
}

impl BodyPrimitive {
    /// A primitive with the vertex indices of a system.
    pub(crate) fn new(system: &System, primitive: Primitive) -> Self {
        // A primitive has a vertex, and each vertex belongs to a body.
        let body = system.bodies.of(primitive.vertices()[0]);
        let first = system.body_vertices()[body].start;
        Self {
            primitive: primitive.map(|vertex| vertex - first),
            body: system.designation(body),
        }
    }

    /// The primitives of a pair of the surface of a system.
    pub(crate) fn of_pair(system: &System, pair: Pair) -> Box<[Self; 2]> {
        Self::both(system, Primitive::of_pair(&system.geometry.mesh, pair))
    }

    /// Two primitives with the vertex indices of a system, in the order of their bodies.
    pub(crate) fn both(system: &System, primitives: [Primitive; 2]) -> Box<[Self; 2]> {
        let [a, b] = primitives.map(|primitive| Self::new(system, primitive));
        Box::new(if b.body.place() < a.body.place() {
            [b, a]
        } else {
            [a, b]
        })
    }
}

impl fmt::Display for BodyPrimitive {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {}", self.primitive, self.body)
    }
}
