//! The pairs of primitives that come near each other in a step.

use rayon::prelude::*;

use crate::bounds::Bounds;
use crate::broad_phase::BroadPhase;
use crate::pair::PairCounts;
use crate::step::Step;

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
        let [x0, x1] = step.positions();
        let (faces, edges) = (step.mesh().faces(), step.mesh().edges());

        let swept = |(&a, &b)| Bounds::of(a).union(&Bounds::of(b));
        let vertex_boxes: Vec<Bounds> = x0.par_iter().zip(x1).map(swept).collect();
        let face_boxes: Vec<Bounds> = faces.par_iter().map(|face| around(&vertex_boxes, face)).collect();
        let vertex_face = broad_phase.between(&vertex_boxes, &face_boxes, |vertex, face| {
            !faces[face as usize].contains(&vertex)
        });

        let edge_boxes: Vec<Bounds> = edges.par_iter().map(|edge| around(&vertex_boxes, edge)).collect();
        let edge_edge = broad_phase.within(&edge_boxes, |a, b| {
            let other = edges[b as usize];
            edges[a as usize].iter().all(|vertex| !other.contains(vertex))
        });

        Self {
            step,
            vertex_face,
            edge_edge,
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

fn around(vertex_boxes: &[Bounds], vertices: &[u32]) -> Bounds {
    vertices.iter().fold(Bounds::EMPTY, |all, &vertex| {
        all.union(&vertex_boxes[vertex as usize])
    })
}
