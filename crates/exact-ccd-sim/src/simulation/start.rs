//! The check that a simulation starts without intersections.

use std::fmt;

use exact_ccd_mesh::{Audit, Pair, TriangleMesh, Violation};

use super::SimulationError;
use crate::state::State;
use crate::system::System;

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

    /// The primitive with its vertex indices mapped by a function.
    pub(crate) fn map(self, number: impl Fn(u32) -> u32) -> Self {
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

/// Checks that no two primitives intersect or touch, including those of two obstacles. An [`Audit`] of the
/// recorded motion starts with the same check.
pub(super) fn check(system: &System, state: &State) -> Result<(), SimulationError> {
    let not_finite = || SimulationError::NotFinite { what: "positions" };
    // The frame has no vertices in the interior of solids, which touch nothing.
    let frame = system.surface_frame(&state.positions).map_err(|_| not_finite())?;
    let mesh = frame.mesh.clone();
    let violation = Audit::default().examine(frame).map_err(|_| not_finite())?;
    match violation {
        None => Ok(()),
        Some(violation) => {
            let primitives = primitives(system, &mesh, &violation);
            let near = state.positions[primitives[0].vertices()[0] as usize];
            Err(SimulationError::Start { primitives, near })
        }
    }
}

/// The two primitives of a violation, with the vertex indices of the system.
fn primitives(system: &System, mesh: &TriangleMesh, violation: &Violation) -> [Primitive; 2] {
    let edge = |edge: u32| Primitive::Edge(mesh.edges()[edge as usize]);
    let face = |face: u32| Primitive::Face(mesh.faces()[face as usize]);
    let primitives = match violation {
        Violation::Intersection { intersection, .. } => [edge(intersection.edge), face(intersection.face)],
        Violation::Contact { contact, .. } => match contact.pair {
            Pair::VertexFace { vertex, face: f } => [Primitive::Vertex(vertex), face(f)],
            Pair::EdgeEdge { a, b } => [edge(a), edge(b)],
            Pair::VertexEdge { vertex, edge: e } => [Primitive::Vertex(vertex), edge(e)],
            Pair::VertexVertex { a, b } => [Primitive::Vertex(a), Primitive::Vertex(b)],
        },
    };
    primitives.map(|primitive| primitive.map(|vertex| system.surface_vertices[vertex as usize]))
}
