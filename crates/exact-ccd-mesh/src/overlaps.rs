//! The stream of candidates of a step.

use std::ops::ControlFlow;

use exact_ccd::{EdgeEdge, Point, VertexFace};
use rayon::prelude::*;

use crate::aabb::{Aabb, meet};
use crate::broad_phase::{BroadPhase, PairSink};
use crate::can_collide::CanCollide;
use crate::candidate_options::{BoxKind, CandidateOptions, DistanceError};
use crate::pair::PairKind;
use crate::step::Step;
use crate::step_boxes::StepBoxes;

/// Passes the candidates of a step on to `vertex_face` and `edge_edge`, in batches.
///
/// # Errors
/// [`DistanceError`], if the distance is negative or not a number.
pub(crate) fn stream(
    step: Step<'_>,
    broad_phase: &impl BroadPhase,
    options: &CandidateOptions,
    vertex_face: &PairSink<'_>,
    edge_edge: &PairSink<'_>,
) -> Result<ControlFlow<()>, DistanceError> {
    let margin = options.margin(step.positions())?;
    let can_collide = &options.can_collide;
    Ok(match options.boxes {
        BoxKind::Swept => {
            let path = |a, b| [Aabb::of(a).union(&Aabb::of(b))];
            Overlaps::<1>::new(step, can_collide, margin, path).visit(broad_phase, vertex_face, edge_edge)
        }
        BoxKind::Moving => {
            let ends = |a, b| [Aabb::of(a), Aabb::of(b)];
            Overlaps::<2>::new(step, can_collide, margin, ends).visit(broad_phase, vertex_face, edge_edge)
        }
    })
}

/// The boxes of all primitives, in single precision for the broad phase, and in double precision to
/// define the result.
struct Overlaps<'a, const T: usize> {
    step: Step<'a>,
    can_collide: &'a CanCollide,
    boxes: StepBoxes<T>,
    vertices: Vec<[Aabb; T]>,
    faces: Vec<[Aabb; T]>,
    edges: Vec<[Aabb; T]>,
}

impl<'a, const T: usize> Overlaps<'a, T> {
    fn new(
        step: Step<'a>,
        can_collide: &'a CanCollide,
        margin: f64,
        of_vertex: impl Fn(Point, Point) -> [Aabb; T] + Sync,
    ) -> Self {
        let [x0, x1] = step.positions();
        let ends = x0.par_iter().zip(x1);
        let vertices: Vec<[Aabb; T]> = if margin == 0.0 {
            ends.map(|(&a, &b)| of_vertex(a, b)).collect()
        } else {
            ends.map(|(&a, &b)| of_vertex(a, b).map(|aabb| aabb.inflated(margin)))
                .collect()
        };
        let mesh = step.mesh();
        let mut boxes = StepBoxes::new(margin);
        boxes.begin(&step, can_collide);
        boxes.vertices_and_faces_until(&step, 1.0);
        boxes.edges_until(&step, 1.0);
        let [faces, edges] = [Vec::new(), Vec::new()];
        let mut overlaps = Self {
            step,
            can_collide,
            boxes,
            vertices,
            faces,
            edges,
        };
        overlaps.faces = overlaps.around(mesh.faces());
        overlaps.edges = overlaps.around(mesh.edges());
        overlaps
    }

    fn around<const N: usize>(&self, primitives: &[[u32; N]]) -> Vec<[Aabb; T]> {
        let around = |vertices: &[u32; N]| {
            core::array::from_fn(|time| {
                vertices.iter().fold(Aabb::EMPTY, |all, &vertex| {
                    all.union(&self.vertices[vertex as usize][time])
                })
            })
        };
        primitives.par_iter().map(around).collect()
    }

    /// Passes the candidates of both kinds on, in batches.
    fn visit(
        &self,
        broad_phase: &impl BroadPhase,
        vertex_face: &PairSink<'_>,
        edge_edge: &PairSink<'_>,
    ) -> ControlFlow<()> {
        let boxes = &self.boxes;
        broad_phase.between(&boxes.vertices, &boxes.faces, &|pairs| {
            vertex_face(&self.among::<VertexFace>(&self.vertices, &self.faces, pairs))
        })?;
        broad_phase.within(&boxes.edges, &|pairs| {
            edge_edge(&self.among::<EdgeEdge>(&self.edges, &self.edges, pairs))
        })
    }

    /// The pairs that can collide and whose boxes meet in double precision.
    fn among<K: PairKind>(&self, a: &[[Aabb; T]], b: &[[Aabb; T]], pairs: &[[u32; 2]]) -> Vec<[u32; 2]> {
        let all_can_collide = self.can_collide.is_all();
        let is_candidate = |ids: &&[u32; 2]| {
            K::vertices(self.step.mesh(), **ids).is_some_and(|four| {
                K::are_apart(&four)
                    && meet(&a[ids[0] as usize], &b[ids[1] as usize])
                    && (all_can_collide || {
                        let (first, second) = four.split_at(K::FIRST);
                        self.can_collide.allows(first, second)
                    })
            })
        };
        pairs.iter().filter(is_candidate).copied().collect()
    }
}
