//! The pairs of primitives that come near each other in a step.

use std::ops::ControlFlow;

use exact_ccd::{EdgeEdge, VertexFace};
use rayon::prelude::*;

use crate::bounds::Bounds;
use crate::broad_phase::{BroadPhase, Found, Visit};
use crate::kind::PairKind;
use crate::pair::PairCounts;
use crate::step::Step;
use crate::step_boxes::StepBoxes;

/// The pairs of primitives whose boxes over the step overlap, without those that share a vertex.
///
/// All contacts of the step are among them, save those between neighbours in the mesh.
#[derive(Clone, Debug)]
pub struct Candidates<'a> {
    step: Step<'a>,
    vertex_face: Vec<[u32; 2]>,
    edge_edge: Vec<[u32; 2]>,
}

impl<'a> Candidates<'a> {
    /// The candidates of a step.
    #[must_use]
    pub fn new(step: Step<'a>, broad_phase: &impl BroadPhase) -> Self {
        let [vertex_face, edge_edge] = [Found::default(), Found::default()];
        let _ = Overlaps::new(step).visit(
            broad_phase,
            &|pairs| vertex_face.keep(pairs.iter().copied()),
            &|pairs| edge_edge.keep(pairs.iter().copied()),
        );
        Self {
            step,
            vertex_face: vertex_face.sorted(),
            edge_edge: edge_edge.sorted(),
        }
    }

    /// The step.
    #[must_use]
    pub fn step(&self) -> Step<'a> {
        self.step
    }

    /// Pairs of a vertex and a face that it is no corner of, sorted.
    #[must_use]
    pub fn vertex_face(&self) -> &[[u32; 2]] {
        &self.vertex_face
    }

    /// Pairs of two edges, the smaller index first, without a common vertex, sorted.
    #[must_use]
    pub fn edge_edge(&self) -> &[[u32; 2]] {
        &self.edge_edge
    }

    /// How many there are of each kind.
    #[must_use]
    pub fn counts(&self) -> PairCounts {
        PairCounts {
            vertex_face: self.vertex_face.len(),
            edge_edge: self.edge_edge.len(),
        }
    }
}

/// The candidates of a step as they are found.
pub(crate) struct Overlaps<'a> {
    step: Step<'a>,
    boxes: StepBoxes<'a, 1>,
    vertices: Vec<Bounds>,
    faces: Vec<Bounds>,
    edges: Vec<Bounds>,
}

impl<'a> Overlaps<'a> {
    pub(crate) fn new(step: Step<'a>) -> Self {
        let [x0, x1] = step.positions();
        let swept = |(&a, &b)| Bounds::of(a).union(&Bounds::of(b));
        let vertices: Vec<Bounds> = x0.par_iter().zip(x1).map(swept).collect();
        let mesh = step.mesh();
        let mut boxes = StepBoxes::new(mesh);
        boxes.begin(&step);
        boxes.vertices_and_faces_until(&step, 1.0);
        boxes.edges_until(&step, 1.0);
        Self {
            step,
            boxes,
            faces: mesh
                .faces()
                .par_iter()
                .map(|face| around(&vertices, face))
                .collect(),
            edges: mesh
                .edges()
                .par_iter()
                .map(|edge| around(&vertices, edge))
                .collect(),
            vertices,
        }
    }

    /// Hands on the candidates of either kind, some at a time.
    pub(crate) fn visit(
        &self,
        broad_phase: &impl BroadPhase,
        vertex_face: &Visit<'_>,
        edge_edge: &Visit<'_>,
    ) -> ControlFlow<()> {
        let StepBoxes {
            vertices,
            faces,
            edges,
            ..
        } = &self.boxes;
        broad_phase.between(vertices, faces, &|pairs| {
            vertex_face(&self.among::<VertexFace>(&self.vertices, &self.faces, pairs))
        })?;
        broad_phase.within(edges, &|pairs| {
            edge_edge(&self.among::<EdgeEdge>(&self.edges, &self.edges, pairs))
        })
    }

    /// The pairs whose boxes overlap before they are rounded.
    fn among<K: PairKind>(&self, a: &[Bounds], b: &[Bounds], pairs: &[[u32; 2]]) -> Vec<[u32; 2]> {
        let overlap = |ids: &&[u32; 2]| {
            K::vertices(self.step.mesh(), **ids).is_some_and(|four| K::are_apart(&four))
                && a[ids[0] as usize].overlaps(&b[ids[1] as usize])
        };
        pairs.iter().filter(overlap).copied().collect()
    }
}

fn around(vertex_boxes: &[Bounds], vertices: &[u32]) -> Bounds {
    vertices.iter().fold(Bounds::EMPTY, |all, &vertex| {
        all.union(&vertex_boxes[vertex as usize])
    })
}
