//! The stream of candidates of a step.

use std::ops::ControlFlow;

use exact_ccd::{AnyKind, Point, environment, with_kind};

use super::margin::Margin;
use super::options::{BoxKind, CandidateError, CandidateOptions};
use super::primitives::Primitives;
use super::step_boxes::StepBoxes;
use crate::broad_phase::{Aabb, BoxPairs, BroadPhase, meet};
use crate::pairs::{CanCollide, Receive, Searched};
use crate::steps::Step;

/// Passes the candidates of a step on.
///
/// # Errors
/// [`CandidateError`], if the distance is negative or not a number, or if the number of thicknesses differs
/// from the number of vertices.
pub(crate) fn stream(
    step: Step<'_>,
    broad_phase: &dyn BroadPhase,
    options: &CandidateOptions,
    receiver: &impl Receive,
) -> Result<ControlFlow<()>, CandidateError> {
    let margin = options.margin(&step)?;
    let can_collide = &options.can_collide;
    // All on threads of the pool: entering it from outside costs a context switch each time.
    Ok(rayon::scope(|_| match options.boxes {
        BoxKind::Swept => {
            let path = |a, b| [Aabb::of(a).union(&Aabb::of(b))];
            let boxes = StepBoxes::around_paths();
            Overlaps::new(step, can_collide, margin, boxes, path).visit(broad_phase, receiver)
        }
        BoxKind::Moving => {
            let ends = |a, b| [Aabb::of(a), Aabb::of(b)];
            let boxes = StepBoxes::default();
            Overlaps::new(step, can_collide, margin, boxes, ends).visit(broad_phase, receiver)
        }
    }))
}

/// The boxes of all primitives in single precision, for the broad phase, and the function that returns the
/// boxes of a vertex in double precision. The box of a primitive contains the boxes of its vertices, and is
/// larger by its margin.
struct Overlaps<'a, const T: usize, F> {
    step: Step<'a>,
    can_collide: &'a CanCollide,
    boxes: StepBoxes<T>,
    of_vertex: F,
    margin: Margin,
}

impl<'a, const T: usize, F: Fn(Point, Point) -> [Aabb; T] + Sync> Overlaps<'a, T, F> {
    fn new(
        step: Step<'a>,
        can_collide: &'a CanCollide,
        margin: Margin,
        mut boxes: StepBoxes<T>,
        of_vertex: F,
    ) -> Self {
        let mut primitives = Primitives::default();
        primitives.begin(&step, can_collide);
        boxes.end(&margin);
        for &kind in AnyKind::ALL {
            with_kind!(kind, K => boxes.place::<K>(&step, &primitives, 1.0));
        }
        Self {
            step,
            can_collide,
            boxes,
            of_vertex,
            margin,
        }
    }

    /// Passes the candidates of all kinds on, in batches.
    fn visit(&self, broad_phase: &dyn BoxPairs<T>, receiver: &impl Receive) -> ControlFlow<()> {
        let mut kinds = AnyKind::ALL.iter();
        kinds.try_for_each(|&kind| with_kind!(kind, K => self.visit_kind::<K>(broad_phase, receiver)))
    }

    fn visit_kind<K: Searched>(
        &self,
        broad_phase: &dyn BoxPairs<T>,
        receiver: &impl Receive,
    ) -> ControlFlow<()> {
        let sink = |pairs: &[_]| match self.among::<K>(pairs) {
            none if none.is_empty() => ControlFlow::Continue(()),
            some => receiver.receive::<K>(&some),
        };
        self.boxes.pairs::<K>(self.step.mesh(), broad_phase, None, &sink)
    }

    /// The pairs that can collide and whose boxes meet in double precision.
    fn among<K: Searched>(&self, pairs: &[[u32; 2]]) -> Vec<[u32; 2]> {
        let all_can_collide = self.can_collide.is_all();
        let lacking = lacking();
        let meet_with_margins = |a: &[u32], b: &[u32]| {
            let [of_a, of_b] = [a, b].map(|vertices| self.around(vertices, lacking));
            let larger = |around: [Aabb; T], vertices: &[u32]| {
                let margin = self.margin.of(vertices);
                around.map(|aabb| aabb.inflated(lacking).inflated(margin))
            };
            // Boxes that meet still meet if they are larger.
            meet(&of_a, &of_b) || meet(&larger(of_a, a), &larger(of_b, b))
        };
        let is_candidate = |ids: &&[u32; 2]| {
            K::vertices(self.step.mesh(), **ids).is_some_and(|vertices| {
                let (a, b) = vertices.as_ref().split_at(K::FIRST);
                K::are_apart(&vertices)
                    && meet_with_margins(a, b)
                    && (all_can_collide || self.can_collide.allows(a, b))
            })
        };
        pairs.iter().filter(is_candidate).copied().collect()
    }

    /// The box around a primitive.
    #[inline(always)]
    fn around(&self, vertices: &[u32], lacking: f64) -> [Aabb; T] {
        let [x0, x1] = self.step.positions();
        let mut around = [Aabb::EMPTY; T];
        for &vertex in vertices {
            let places = (self.of_vertex)(x0[vertex as usize], x1[vertex as usize]);
            for (all, aabb) in around.iter_mut().zip(places) {
                *all = all.union(&aabb.inflated(lacking));
            }
        }
        around
    }
}

/// The margin with which a union of boxes has all of their points. Where comparisons read subnormal numbers
/// as zero, the union may lack points by less than the least normal number.
fn lacking() -> f64 {
    if environment::is_default() {
        0.0
    } else {
        f64::MIN_POSITIVE
    }
}
