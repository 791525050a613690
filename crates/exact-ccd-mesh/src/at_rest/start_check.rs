//! The check that no edge passes through a face where a step begins.

use exact_ccd::Point;

use super::intersections::{Intersection, IntersectionOptions, Meeting, intersections_at_start};
use crate::broad_phase::BroadPhase;
use crate::overlaps::Primitives;
use crate::pairs::CanCollide;
use crate::steps::{Step, StepError};

/// Positions known to be without crossings, so that most steps of a simulation need no pass over the mesh.
///
/// A step that is free of contact and begins without crossings has none at its end, if all primitives that
/// take part can collide. Let an edge and a face without a common vertex meet in the step, first at the time
/// t. They do not cross at t: not at t = 0, where nothing does, and not later, because primitives that cross
/// did so a little before. So an end of the edge is in the face, or the edge meets a side. Either is a
/// contact, of a vertex and the face or of two edges. A predicate may leave out these pairs but not the edge
/// and the face; with one, only positions that were checked themselves are known.
#[derive(Clone, Debug, Default)]
pub(crate) struct StartCheck {
    /// The last start that was checked or known.
    start: Vec<Point>,
    /// The end of the last step that was found free of contact.
    end: Vec<Point>,
    passes: usize,
}

impl StartCheck {
    /// The number of passes over a mesh at rest.
    pub(crate) fn passes(&self) -> usize {
        self.passes
    }

    /// Forgets the positions that are known: other pairs can collide from now on.
    pub(crate) fn forget(&mut self) {
        (self.start, self.end) = (Vec::new(), Vec::new());
    }

    /// Makes certain that nothing that counts crosses at the start of a step. The primitives begin the step
    /// only if the mesh is searched.
    ///
    /// # Errors
    /// [`StepError::Crossing`] has the first edge that crosses a face, and counts with it.
    pub(crate) fn examine(
        &mut self,
        broad_phase: &dyn BroadPhase,
        step: &Step<'_>,
        primitives: &mut Primitives,
        can_collide: &CanCollide,
        counts: &dyn Fn(Intersection) -> bool,
    ) -> Result<(), StepError> {
        let (mesh, [x0, _]) = (step.mesh(), step.positions());
        if are_same(x0, &self.start) {
            return Ok(());
        }
        if are_same(x0, &self.end) {
            self.start.clone_from(&self.end);
            return Ok(());
        }
        self.passes += 1;
        let options = IntersectionOptions::default().with_meeting(Meeting::Crossing);
        let options = options.with_can_collide(can_collide.clone());
        primitives.begin(step, can_collide);
        let crossings = intersections_at_start(step, primitives, broad_phase, &options);
        if let Some(first) = crossings.into_iter().find(|&crossing| counts(crossing)) {
            return Err(first.crossing(mesh));
        }
        self.start = x0.to_vec();
        Ok(())
    }

    /// Takes the end of a step whose start was examined and in which no pair touches.
    pub(crate) fn add_end_of_free(&mut self, x1: &[Point], can_collide: &CanCollide) {
        if !can_collide.has_predicate() {
            self.end = x1.to_vec();
        }
    }
}

/// Returns true if the positions are the same bits: a comparison of numbers may read subnormal ones as zero.
fn are_same(x: &[Point], y: &[Point]) -> bool {
    let bits = |point: &Point| point.map(f64::to_bits);
    // No positions are known at first, and a mesh without vertices has no crossings.
    x.len() == y.len() && x.iter().map(bits).eq(y.iter().map(bits))
}
