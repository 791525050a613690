//! The motion of bodies with scripts in a Newton iteration.

use std::time::Instant;

use exact_ccd_mesh::{MinDistance, Step};
use nalgebra::Vector3;

use super::direction::{FARTHEST, SLACK};
use super::newton::{Iterate, Newton};
use super::potential::Potential;
use super::vertex_steps::VertexSteps;
use crate::settings::LineSearch;
use crate::statistics::Statistics;

/// The number of parts of a motion that are tried.
const SHORTER: usize = 8;

/// The part of all motions together below which each body is moved alone.
const TOGETHER: f64 = 0.1;

/// The part of the contact distance beyond which surfaces hardly repel each other.
const APART: f64 = 0.9;

impl Newton<'_> {
    /// Moves the bodies with scripts: all of them together with the Newton direction of all other vertices,
    /// or else alone, or else each body alone, by the parts of their motions that are free. With a line
    /// search by vertex, all of them first go all the way, if it suffices that the other vertices stay
    /// behind. Returns true if a body moves.
    pub(super) fn prescribe(
        &self,
        steps: &mut VertexSteps,
        now: &mut Iterate<'_>,
        direction: &[Vector3<f64>],
        potential: &Potential<'_>,
        statistics: &mut Statistics,
    ) -> bool {
        let clock = Instant::now();
        let all = now.dirichlet.places();
        let was_apart = now.collisions.minimal_distance() > APART * self.barrier.activation_distance();
        let mut progress = if self.move_by_vertex(steps, now, &all, direction, potential) {
            1.0
        } else {
            self.move_bodies(now, &all, Some(direction), potential)
        };
        if progress < TOGETHER {
            progress += self.move_bodies(now, &all, None, potential);
        }
        if progress < TOGETHER && all.len() > 1 {
            for &place in &all {
                progress += self.move_bodies(now, &[place], None, potential);
            }
        }
        now.dirichlet.moved(progress, was_apart);
        statistics.seconds.ccd += clock.elapsed().as_secs_f64();
        statistics.step_sizes.push(progress.min(1.0));
        progress > 0.0
    }

    /// Moves some bodies by the largest part of the rest of their motions that is free, up to halving, and
    /// for which the potential is finite. Returns the part, 0 if there is none.
    fn move_bodies(
        &self,
        now: &mut Iterate<'_>,
        places: &[usize],
        direction: Option<&[Vector3<f64>]>,
        potential: &Potential<'_>,
    ) -> f64 {
        let end = |now: &Iterate<'_>, part: f64| {
            let mut end = match direction {
                None => now.positions.clone(),
                Some(direction) => self.displaced(&now.positions, direction, part),
            };
            now.dirichlet.set(&mut end, places, part);
            self.system.carriers.carry(&mut end);
            end
        };
        let whole = end(now, 1.0);
        let moves = now.positions.iter().zip(&whole);
        let size = moves.fold(0.0_f64, |size, (a, b)| {
            size.max((Vector3::from(*b) - Vector3::from(*a)).amax())
        });
        let mut part = (FARTHEST * self.system.extent() / size).min(1.0);
        for attempt in 0..SHORTER {
            let end = end(now, part);
            let Ok(step) = Step::new(&self.system.geometry.mesh, &now.positions, &end) else {
                return 0.0;
            };
            let candidates = self.system.geometry.near(step, &self.barrier);
            let obstacles = self.system.geometry.obstacle_pairs(step);
            // Offsets do not act between obstacles.
            let contact = MinDistance::default();
            if self.is_free(&candidates, step) && self.filter.is_free(&obstacles, step, &contact) {
                let collisions = self.collisions(&candidates, &end);
                if potential.value(&end, collisions.as_slice()).is_finite() {
                    now.positions = end;
                    now.collisions = collisions;
                    now.dirichlet.advance(places, part);
                    return part;
                }
            }
            let free = if attempt == 0 {
                let free = self
                    .filter
                    .free_part(&candidates, step, &self.system.geometry.min_distance);
                free.min(self.filter.free_part(&obstacles, step, &contact))
                    .min(self.system.geometry.free_of_half_spaces(step))
            } else {
                1.0
            };
            part *= if free < 1.0 { SLACK * free } else { 0.5 };
        }
        0.0
    }

    /// Moves all bodies to the ends of their motions, and every other vertex along the Newton direction by a
    /// part of its own. Returns false if this is not free, or the potential is not finite there.
    fn move_by_vertex(
        &self,
        steps: &mut VertexSteps,
        now: &mut Iterate<'_>,
        places: &[usize],
        direction: &[Vector3<f64>],
        potential: &Potential<'_>,
    ) -> bool {
        let size = direction.iter().fold(0.0_f64, |size, part| size.max(part.amax()));
        if self.settings.line_search != LineSearch::Vertex || size > FARTHEST * self.system.extent() {
            return false;
        }
        let mut whole = self.displaced(&now.positions, direction, 1.0);
        now.dirichlet.set(&mut whole, places, 1.0);
        let surface = &self.system.geometry.mesh;
        let end = Step::new(surface, &now.positions, &whole)
            .ok()
            .and_then(|step| steps.truncated(self.system, step, &now.dirichlet.vertices()));
        let Some(end) = end else { return false };
        let Ok(step) = Step::new(surface, &now.positions, &end) else {
            return false;
        };
        let candidates = self.system.geometry.near(step, &self.barrier);
        let obstacles = self.system.geometry.obstacle_pairs(step);
        let is_free =
            self.is_free(&candidates, step) && self.filter.is_free(&obstacles, step, &MinDistance::default());
        let collisions = self.collisions(&candidates, &end);
        let is_taken = is_free && potential.value(&end, collisions.as_slice()).is_finite();
        if is_taken {
            now.positions = end;
            now.collisions = collisions;
            now.dirichlet.advance(places, 1.0);
        }
        is_taken
    }
}
