//! The primitives of a body.

use arrayvec::ArrayVec;
use exact_ccd::{AnyKind, Point};

use super::sphere::Sphere;
use crate::mesh::{Frame, TriangleMesh};

/// Vertices, edges or faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    Vertex,
    Edge,
    Face,
}

/// A primitive of a body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Primitive {
    pub(super) shape: Shape,
    /// True for a vertex or an edge without a face.
    is_loose: bool,
    /// The index in the mesh.
    pub(super) id: u32,
    pub(super) sphere: Sphere,
}

impl Shape {
    /// The shapes of the first and of the second primitive of a kind of pairs.
    pub(super) fn of_kind(kind: AnyKind) -> [Self; 2] {
        match kind {
            AnyKind::VertexFace => [Self::Vertex, Self::Face],
            AnyKind::EdgeEdge => [Self::Edge; 2],
            AnyKind::VertexEdge => [Self::Vertex, Self::Edge],
            AnyKind::VertexVertex => [Self::Vertex; 2],
        }
    }

    /// The vertices of a primitive of a mesh that has it.
    pub(super) fn vertices(self, mesh: &TriangleMesh, id: u32) -> ArrayVec<u32, 3> {
        match self {
            Self::Vertex => [id].into_iter().collect(),
            Self::Face => mesh.faces()[id as usize].into_iter().collect(),
            Self::Edge => mesh.edges()[id as usize].into_iter().collect(),
        }
    }
}

impl Primitive {
    /// All primitives of a mesh.
    pub(super) fn all(
        mesh: &TriangleMesh,
        sphere: impl Fn(Shape, u32) -> Sphere,
    ) -> impl Iterator<Item = Self> {
        let mut loose_vertices = mesh.loose_vertices().peekable();
        let vertices = (0..mesh.vertex_count() as u32)
            .map(move |id| (Shape::Vertex, id, loose_vertices.next_if_eq(&id).is_some()));
        let first_loose = mesh.edges().len() - mesh.loose_edges().len();
        let edges =
            (0..mesh.edges().len() as u32).map(move |id| (Shape::Edge, id, id as usize >= first_loose));
        let faces = (0..mesh.faces().len() as u32).map(|id| (Shape::Face, id, false));
        let all = vertices.chain(edges).chain(faces);
        all.map(move |(shape, id, is_loose)| Self {
            shape,
            is_loose,
            id,
            sphere: sphere(shape, id),
        })
    }

    /// The positions of its vertices in a body that has it.
    pub(super) fn points(&self, frame: &Frame) -> ArrayVec<Point, 3> {
        let vertices = self.shape.vertices(&frame.mesh, self.id).into_iter();
        vertices.map(|vertex| frame.positions[vertex as usize]).collect()
    }

    /// The kind of the pair of two primitives of different bodies, if they are compared, and true if the
    /// second one is the first of the kind.
    pub(super) fn kind_with(&self, other: &Self) -> Option<(AnyKind, bool)> {
        let both_loose = self.is_loose && other.is_loose;
        match (self.shape, other.shape) {
            (Shape::Vertex, Shape::Face) => Some((AnyKind::VertexFace, false)),
            (Shape::Face, Shape::Vertex) => Some((AnyKind::VertexFace, true)),
            (Shape::Edge, Shape::Edge) => Some((AnyKind::EdgeEdge, false)),
            (Shape::Vertex, Shape::Edge) if both_loose => Some((AnyKind::VertexEdge, false)),
            (Shape::Edge, Shape::Vertex) if both_loose => Some((AnyKind::VertexEdge, true)),
            (Shape::Vertex, Shape::Vertex) if both_loose => Some((AnyKind::VertexVertex, false)),
            _ => None,
        }
    }
}
