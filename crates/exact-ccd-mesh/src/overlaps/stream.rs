//! The stream of candidates of a step.

use std::ops::ControlFlow;

use exact_ccd::{EdgeEdge, Point, VertexEdge, VertexFace, VertexVertex, environment};
use rayon::prelude::*;

use super::margin::Margin;
use super::options::{BoxKind, CandidateError, CandidateOptions};
use super::step_boxes::StepBoxes;
use crate::broad_phase::{Aabb, BroadPhase, meet};
use crate::pairs::{CanCollide, PrimitiveSet, Searched};
use crate::steps::Step;

/// A receiver of candidates, in batches in any order, on any thread.
pub(crate) trait Receive: Sync {
    /// Receives candidates of one kind. `Break` ends the search.
    fn receive<K: Searched>(&self, pairs: Vec<[u32; 2]>) -> ControlFlow<()>;
}

/// Passes the candidates of a step on.
///
/// # Errors
/// [`CandidateError`], if the distance is negative or not a number, or if the number of thicknesses
/// is not that of vertices.
pub(crate) fn stream(
    step: Step<'_>,
    broad_phase: &impl BroadPhase,
    options: &CandidateOptions,
    receiver: &impl Receive,
) -> Result<ControlFlow<()>, CandidateError> {
    let margin = options.margin(&step)?;
    let can_collide = &options.can_collide;
    Ok(match options.boxes {
        BoxKind::Swept => {
            let path = |a, b| [Aabb::of(a).union(&Aabb::of(b))];
            Overlaps::<1>::new(step, can_collide, margin, path).visit(broad_phase, receiver)
        }
        BoxKind::Moving => {
            let ends = |a, b| [Aabb::of(a), Aabb::of(b)];
            Overlaps::<2>::new(step, can_collide, margin, ends).visit(broad_phase, receiver)
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
        margin: Margin,
        of_vertex: impl Fn(Point, Point) -> [Aabb; T] + Sync,
    ) -> Self {
        let [x0, x1] = step.positions();
        let ends = x0.par_iter().zip(x1);
        let bare: Vec<[Aabb; T]> = ends.map(|(&a, &b)| of_vertex(a, b).map(whole)).collect();
        let faces = around(&bare, step.mesh().faces(), &margin);
        let edges = around(&bare, step.mesh().edges(), &margin);
        let vertices = inflated(bare, &margin);
        let mut boxes = StepBoxes::default();
        boxes.end(&margin);
        boxes.place::<VertexFace>(&step, can_collide, 1.0);
        boxes.place::<EdgeEdge>(&step, can_collide, 1.0);
        boxes.place::<VertexEdge>(&step, can_collide, 1.0);
        boxes.place::<VertexVertex>(&step, can_collide, 1.0);
        Self {
            step,
            can_collide,
            boxes,
            vertices,
            faces,
            edges,
        }
    }

    /// Passes the candidates of all kinds on, in batches.
    fn visit(&self, broad_phase: &impl BroadPhase, receiver: &impl Receive) -> ControlFlow<()> {
        self.visit_kind::<VertexFace>(broad_phase, receiver)?;
        self.visit_kind::<EdgeEdge>(broad_phase, receiver)?;
        self.visit_kind::<VertexEdge>(broad_phase, receiver)?;
        self.visit_kind::<VertexVertex>(broad_phase, receiver)
    }

    fn visit_kind<K: Searched>(
        &self,
        broad_phase: &impl BroadPhase,
        receiver: &impl Receive,
    ) -> ControlFlow<()> {
        let sink = |pairs: &[_]| receiver.receive::<K>(self.among::<K>(pairs));
        self.boxes.pairs::<K>(self.step.mesh(), broad_phase, None, &sink)
    }

    /// The pairs that can collide and whose boxes meet in double precision.
    fn among<K: Searched>(&self, pairs: &[[u32; 2]]) -> Vec<[u32; 2]> {
        let all_can_collide = self.can_collide.is_all();
        let [a, b] = K::SETS.map(|set| self.of_set(set));
        let is_candidate = |ids: &&[u32; 2]| {
            K::vertices(self.step.mesh(), **ids).is_some_and(|vertices| {
                K::are_apart(&vertices)
                    && meet(&a[ids[0] as usize], &b[ids[1] as usize])
                    && (all_can_collide || {
                        let (first, second) = vertices.as_ref().split_at(K::FIRST);
                        self.can_collide.allows(first, second)
                    })
            })
        };
        pairs.iter().filter(is_candidate).copied().collect()
    }

    /// The boxes of a set, by the indices of the primitives in the mesh.
    fn of_set(&self, set: PrimitiveSet) -> &[[Aabb; T]] {
        match set {
            PrimitiveSet::Vertices | PrimitiveSet::LooseVertices | PrimitiveSet::Ends => &self.vertices,
            PrimitiveSet::Faces => &self.faces,
            PrimitiveSet::Edges | PrimitiveSet::LooseEdges => &self.edges,
        }
    }
}

/// A union of boxes that lacks none of their points. Where comparisons read subnormal numbers as zero, the
/// union may lack those.
fn whole(union: Aabb) -> Aabb {
    if environment::is_default() {
        union
    } else {
        union.inflated(f64::MIN_POSITIVE)
    }
}

/// The boxes of primitives, from those of their vertices without margins.
fn around<const T: usize, const N: usize>(
    bare: &[[Aabb; T]],
    primitives: &[[u32; N]],
    margin: &Margin,
) -> Vec<[Aabb; T]> {
    let around = |vertices: &[u32; N]| -> [Aabb; T] {
        core::array::from_fn(|time| {
            let boxes = vertices.iter().map(|&vertex| &bare[vertex as usize][time]);
            whole(boxes.fold(Aabb::EMPTY, |all, aabb| all.union(aabb)))
        })
    };
    let primitives = primitives.par_iter();
    if margin.uniform() == Some(0.0) {
        return primitives.map(around).collect();
    }
    let inflated = |vertices: &[u32; N]| {
        let margin = margin.of(vertices);
        around(vertices).map(|aabb| aabb.inflated(margin))
    };
    primitives.map(inflated).collect()
}

/// The boxes of vertices, with margins.
fn inflated<const T: usize>(mut bare: Vec<[Aabb; T]>, margin: &Margin) -> Vec<[Aabb; T]> {
    if margin.uniform() != Some(0.0) {
        bare.par_iter_mut().enumerate().for_each(|(vertex, boxes)| {
            let margin = margin.of(&[vertex as u32]);
            *boxes = boxes.map(|aabb| aabb.inflated(margin));
        });
    }
    bare
}
