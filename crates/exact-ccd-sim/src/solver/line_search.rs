//! The line search of a Newton iteration: its step is free of contact and decreases the potential.

use std::time::Instant;

use exact_ccd_mesh::{Candidates, MinDistance, Point, Step};
use nalgebra::Vector3;

use super::newton::{Iterate, Newton};
use super::potential::Potential;
use crate::contact::Collisions;
use crate::simulation::SimulationError;
use crate::statistics::Statistics;

/// The largest step size relative to the free part of a step. The barrier is infinite at contact.
const SLACK: f64 = 0.9;

/// The number of halvings after which the line search fails.
const HALVINGS: usize = 60;

/// The largest displacement of a vertex in one iteration, relative to the extent of the scene. A larger one
/// would sweep over too many pairs, and is far from the minimum.
const FARTHEST: f64 = 0.25;

/// The number of parts of a motion that are tried.
const SHORTER: usize = 8;

/// The part of all motions together below which each body is moved alone.
const TOGETHER: f64 = 0.1;

impl Newton<'_> {
    /// Moves the bodies with scripts: all of them together with the Newton direction of all other vertices,
    /// or else alone, or else each body alone, by the parts of their motions that are free. Returns true if
    /// a body moves.
    pub(super) fn prescribe(
        &self,
        now: &mut Iterate<'_>,
        direction: &[Vector3<f64>],
        potential: &Potential<'_>,
        statistics: &mut Statistics,
    ) -> bool {
        let clock = Instant::now();
        let all: Vec<usize> = (0..now.dirichlet.motions().len()).collect();
        let mut progress = self.move_bodies(now, &all, Some(direction), potential);
        if progress < TOGETHER {
            progress += self.move_bodies(now, &all, None, potential);
        }
        if progress < TOGETHER && all.len() > 1 {
            for &place in &all {
                progress += self.move_bodies(now, &[place], None, potential);
            }
        }
        now.dirichlet.moved(progress);
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
                Some(direction) => displaced(&now.positions, direction, part),
            };
            now.dirichlet.set(&mut end, places, part);
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
            let Ok(step) = Step::new(&self.system.surface, &now.positions, &end) else {
                return 0.0;
            };
            let candidates = self.system.near(step, &self.barrier);
            let obstacles = self.system.obstacle_pairs(step);
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
                    .free_part(&candidates, step, self.system.min_distance());
                free.min(self.filter.free_part(&obstacles, step, &contact))
                    .min(self.system.free_of_half_spaces(step))
            } else {
                1.0
            };
            part *= if free < 1.0 { SLACK * free } else { 0.5 };
        }
        0.0
    }

    /// Takes a step along a direction that is free of contact and decreases the potential. Returns false if
    /// there is none.
    pub(super) fn search(
        &self,
        now: &mut Iterate<'_>,
        direction: &[Vector3<f64>],
        size: f64,
        potential: &Potential<'_>,
        statistics: &mut Statistics,
    ) -> Result<bool, SimulationError> {
        let clock = Instant::now();
        let longest = (FARTHEST * self.system.extent() / size).min(1.0);
        let end = displaced(&now.positions, direction, longest);
        let blocked = || SimulationError::Blocked {
            step: statistics.step,
            filter: self.filter.name().to_owned(),
        };
        let surface = &self.system.surface;
        // A direction that is not finite is rejected like one into a contact.
        let step = Step::new(surface, &now.positions, &end).map_err(|_| blocked())?;
        let candidates = self.system.near(step, &self.barrier);
        let free = self
            .filter
            .free_part(&candidates, step, self.system.min_distance());
        let free = free.min(self.system.free_of_half_spaces(step));
        if free <= 0.0 {
            return Err(blocked());
        }
        statistics.seconds.ccd += clock.elapsed().as_secs_f64();

        let before = potential.value(&now.positions, now.collisions.as_slice());
        let mut part = if free < 1.0 { SLACK * free } else { 1.0 };
        for _ in 0..HALVINGS {
            let clock = Instant::now();
            let positions = step.at(part);
            // If the step is rounded to nothing, so are all shorter ones.
            if size > 0.0 && positions == now.positions {
                break;
            }
            let collisions = self.collisions(&candidates, &positions);
            let after = potential.value(&positions, collisions.as_slice());
            statistics.seconds.line_search += clock.elapsed().as_secs_f64();
            let falls = after <= before
                || after <= before + potential.noise(before)
                    && self.flattens(now, direction, potential, &positions, &collisions);
            if falls {
                let clock = Instant::now();
                // A full step is taken only if all of it is free.
                let free = part >= 1.0
                    || Step::new(surface, &now.positions, &positions)
                        .is_ok_and(|step| self.is_free(&candidates, step));
                statistics.seconds.ccd += clock.elapsed().as_secs_f64();
                if free {
                    let least = [now.collisions.minimal_distance(), collisions.minimal_distance()];
                    now.stiffness = self.range.adapt(now.stiffness, least[0], least[1]);
                    now.positions = positions;
                    now.collisions = collisions;
                    statistics.step_sizes.push(part * longest);
                    return Ok(true);
                }
            }
            part *= 0.5;
        }
        statistics.step_sizes.push(0.0);
        Ok(false)
    }

    /// Returns true if the slope of the potential along a direction is small enough at the new positions:
    /// the test of descent where rounding hides the difference of two values. This is the approximate Wolfe
    /// condition of W. Hager and H. Zhang, *A new conjugate gradient method with guaranteed descent and an
    /// efficient line search*, 2005.
    fn flattens(
        &self,
        now: &Iterate<'_>,
        direction: &[Vector3<f64>],
        potential: &Potential<'_>,
        positions: &[Point],
        collisions: &Collisions,
    ) -> bool {
        let slope = |gradient: Vec<Vector3<f64>>| -> f64 {
            gradient
                .iter()
                .zip(direction)
                .map(|(gradient, direction)| gradient.dot(direction))
                .sum()
        };
        let before = slope(potential.gradient(&now.positions, now.collisions.as_slice()));
        slope(potential.gradient(positions, collisions.as_slice())) <= -0.8 * before
    }

    /// True if a step is free of contact: between surfaces by the filter, with half spaces exactly.
    fn is_free(&self, candidates: &Candidates, step: Step<'_>) -> bool {
        let free = self.filter.is_free(candidates, step, self.system.min_distance());
        free && self.system.first_grounded(step.positions()[1]).is_none()
    }

    fn collisions(&self, candidates: &Candidates, points: &[Point]) -> Collisions {
        Collisions::new(
            self.system.contact_surface(self.formulation),
            candidates,
            points,
            self.barrier,
        )
    }
}

fn displaced(points: &[Point], direction: &[Vector3<f64>], size: f64) -> Vec<Point> {
    let along = |(x, d): (&Point, &Vector3<f64>)| (Vector3::from(*x) + d * size).into();
    points.iter().zip(direction).map(along).collect()
}
