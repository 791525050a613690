//! A body at rest in its own coordinates, prepared for steps.

use arrayvec::ArrayVec;
use exact_ccd::Point;

use super::error::BodiesError;
use crate::broad_phase::{Aabb, Boxes, TooManyPrimitives};
use crate::mesh::{Frame, TriangleMesh, check_positions};
use crate::vector::{dot, minus};

/// The sets of primitives that are compared with sets of other bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Set {
    Vertices,
    Faces,
    Edges,
    LooseVertices,
    LooseEdges,
}

/// A body, and the boxes of its primitives.
#[derive(Clone, Debug)]
pub(super) struct Body {
    pub(super) frame: Frame,
    loose_vertices: Vec<u32>,
    /// A ball around the body.
    pub(super) center: Point,
    pub(super) radius: f64,
    /// The box of all vertices.
    pub(super) around: Aabb,
    /// The boxes of each set of primitives, relative to the center.
    resting: Vec<Boxes<1>>,
}

impl Body {
    pub(super) fn new(index: usize, frame: Frame) -> Result<Self, BodiesError> {
        let refused = |error| BodiesError::Positions { body: index, error };
        check_positions(frame.mesh.vertex_count(), &frame.positions).map_err(refused)?;
        let boxes: Vec<Aabb> = frame.positions.iter().map(|&point| Aabb::of(point)).collect();
        let around = boxes.iter().fold(Aabb::EMPTY, |all, next| all.union(next));
        let center = if boxes.is_empty() {
            [0.0; 3]
        } else {
            around.center()
        };
        let distances = frame.positions.iter().map(|&point| {
            let offset = minus(point, center);
            dot(offset, offset).sqrt()
        });
        // The length has less than ten roundings, in any direction; squares below 2⁻¹⁰²² may vanish.
        let radius = distances.fold(0.0, f64::max) * (1.0 + 1e-12) + 1e-150;
        let mut body = Self {
            loose_vertices: frame.mesh.loose_vertices().collect(),
            center,
            radius,
            around,
            resting: Vec::new(),
            frame,
        };
        let resting = Set::ALL.map(|set| body.boxes_of(set, &boxes, 0.0, center));
        let resting: Result<_, _> = resting.into_iter().collect();
        body.resting = resting.map_err(|error| BodiesError::TooManyPrimitives { body: index, error })?;
        Ok(body)
    }

    /// The index in the mesh of a primitive of a set.
    pub(super) fn id(&self, set: Set, index: u32) -> u32 {
        match set {
            Set::LooseVertices => self.loose_vertices[index as usize],
            Set::LooseEdges => {
                let mesh = &self.frame.mesh;
                (mesh.edges().len() - mesh.loose_edges().len()) as u32 + index
            }
            Set::Vertices | Set::Faces | Set::Edges => index,
        }
    }

    /// The boxes of a set of primitives at rest.
    pub(super) fn resting(&self, set: Set) -> &Boxes<1> {
        &self.resting[set as usize]
    }

    /// The boxes of a set of primitives, given the vertices' boxes, larger by a distance and relative to an
    /// origin.
    pub(super) fn boxes_of(
        &self,
        set: Set,
        vertices: &[Aabb],
        distance: f64,
        origin: Point,
    ) -> Result<Boxes<1>, TooManyPrimitives> {
        let around = |primitive: &[u32]| {
            let boxes = primitive.iter().map(|&vertex| vertices[vertex as usize]);
            let all = boxes.fold(Aabb::EMPTY, |all, next| all.union(&next));
            [all.inflated(distance)]
        };
        let mesh = &self.frame.mesh;
        let boxes: Vec<_> = match set {
            Set::Vertices => vertices
                .iter()
                .map(|vertex| [vertex.inflated(distance)])
                .collect(),
            Set::Faces => mesh.faces().iter().map(|face| around(face)).collect(),
            Set::Edges => mesh.edges().iter().map(|edge| around(edge)).collect(),
            Set::LooseVertices => self.loose_vertices.iter().map(|&v| around(&[v])).collect(),
            Set::LooseEdges => mesh.loose_edges().iter().map(|edge| around(edge)).collect(),
        };
        Boxes::relative_to(&boxes, &[origin])
    }
}

impl Set {
    /// All sets, in their order.
    const ALL: [Self; 5] = [
        Self::Vertices,
        Self::Faces,
        Self::Edges,
        Self::LooseVertices,
        Self::LooseEdges,
    ];

    /// The vertices of a primitive of a mesh that has it.
    pub(super) fn vertices(self, mesh: &TriangleMesh, id: u32) -> ArrayVec<u32, 3> {
        match self {
            Self::Vertices | Self::LooseVertices => [id].into_iter().collect(),
            Self::Faces => mesh.faces()[id as usize].into_iter().collect(),
            Self::Edges | Self::LooseEdges => mesh.edges()[id as usize].into_iter().collect(),
        }
    }
}
