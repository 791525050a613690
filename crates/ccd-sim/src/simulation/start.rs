//! Where a simulation may start.

use std::fmt;

use ccd_mesh::{Audit, Pair, TriangleMesh, Violation};

use super::SimulationError;
use crate::state::State;
use crate::system::System;

/// Two primitives of a system, by their vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meeting {
    /// A vertex and a face.
    VertexFace(u32, [u32; 3]),
    /// Two edges.
    EdgeEdge([u32; 2], [u32; 2]),
    /// An edge and a face.
    EdgeFace([u32; 2], [u32; 3]),
}

impl fmt::Display for Meeting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::VertexFace(vertex, face) => write!(f, "the vertex {vertex} and the face {face:?}"),
            Self::EdgeEdge(a, b) => write!(f, "the edges {a:?} and {b:?}"),
            Self::EdgeFace(edge, face) => write!(f, "the edge {edge:?} and the face {face:?}"),
        }
    }
}

/// Whether nothing meets at the start, two obstacles included: as an [`Audit`] sees it, which begins with the same frame.
pub(super) fn check(system: &System, state: &State) -> Result<(), SimulationError> {
    let not_finite = || SimulationError::NotFinite { what: "positions" };
    // Without the vertices inside of solids, which meet nothing.
    let frame = system.surface_frame(&state.positions).map_err(|_| not_finite())?;
    let mesh = frame.mesh.clone();
    let violation = Audit::default().examine(frame).map_err(|_| not_finite())?;
    match violation {
        None => Ok(()),
        Some(violation) => Err(SimulationError::Start(meeting(system, &mesh, &violation))),
    }
}

/// What meets, with the numbers that its vertices have in the system.
fn meeting(system: &System, mesh: &TriangleMesh, violation: &Violation) -> Meeting {
    let vertex = |vertex: u32| system.surface.vertices()[vertex as usize];
    let edge = |edge: u32| mesh.edges()[edge as usize].map(vertex);
    let face = |face: u32| mesh.faces()[face as usize].map(vertex);
    match violation {
        Violation::Intersection { intersection, .. } => {
            Meeting::EdgeFace(edge(intersection.edge), face(intersection.face))
        }
        Violation::Contact { contact, .. } => match contact.pair {
            Pair::VertexFace { vertex: v, face: f } => Meeting::VertexFace(vertex(v), face(f)),
            Pair::EdgeEdge { a, b } => Meeting::EdgeEdge(edge(a), edge(b)),
        },
    }
}
