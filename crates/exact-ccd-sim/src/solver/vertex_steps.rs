//! The part of a step that each vertex can take.

use exact_ccd_mesh::{Detector, FreeStepOptions, Point, Step};
use nalgebra::Vector3;

use super::direction::SLACK;
use crate::system::System;

/// Finds the part of a step that each vertex can take, in successive steps of one system.
#[derive(Default)]
pub(crate) struct VertexSteps(Option<Detector>);

impl VertexSteps {
    /// The positions to which the vertices can go, each on its straight way to the end of a step: free of
    /// contact between surfaces by [`Detector::free_steps`], and with half spaces up to rounding. `pinned`
    /// vertices go all the way. `None` if pairs touch even so.
    pub(super) fn truncated(
        &mut self,
        system: &System,
        step: Step<'_>,
        pinned: &[u32],
    ) -> Option<Vec<Point>> {
        let detector = self.0.get_or_insert_with(|| {
            Detector::new(system.geometry.mesh.clone()).with_can_collide(system.geometry.can_collide.clone())
        });
        let options = FreeStepOptions::default()
            .with_keep(SLACK)
            .with_min_distance(system.geometry.min_distance.clone());
        let [start, _] = step.positions();
        let end = above_half_spaces(system, step, pinned);
        let steps = detector.free_steps(start, &end, pinned, &options).ok()?;
        steps.blocked.is_empty().then_some(steps.positions)
    }
}

/// The end of a step, but with a vertex that would enter a half space at its part of the way to it.
fn above_half_spaces(system: &System, step: Step<'_>, pinned: &[u32]) -> Vec<Point> {
    let [start, end] = step.positions();
    let mut above = end.to_vec();
    for (vertex, free) in system.geometry.held_back_by_half_spaces(step) {
        if pinned.binary_search(&vertex).is_err() {
            let vertex = vertex as usize;
            let [x, to] = [start[vertex], end[vertex]].map(Vector3::from);
            above[vertex] = (x + (to - x) * (SLACK * free)).into();
        }
    }
    above
}
