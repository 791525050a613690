//! The line search of a Newton iteration: its step is free of contact and decreases the potential.

use std::time::Instant;

use exact_ccd_mesh::{Candidates, Pair, Point, Step};
use nalgebra::Vector3;

use super::direction::{Direction, FARTHEST, SLACK, dot};
use super::newton::{Iterate, Newton};
use super::potential::Potential;
use super::vertex_steps::VertexSteps;
use crate::energies::contact::CollisionSet;
use crate::error::SimulationError;
use crate::settings::LineSearch;
use crate::statistics::Statistics;
use crate::system::BodyPrimitive;

/// The number of halvings after which the line search fails.
const HALVINGS: usize = 60;

/// A step that is free of contact and decreases the potential.
pub(super) struct Taken {
    pub(super) positions: Vec<Point>,
    pub(super) collisions: CollisionSet,
    /// The value of the potential there.
    pub(super) value: f64,
    /// The length of the step, relative to the Newton direction.
    pub(super) size: f64,
}

impl Iterate<'_> {
    /// The value of the potential.
    pub(super) fn potential(&self, potential: &Potential<'_>) -> f64 {
        let value = || potential.value(&self.positions, self.collisions.as_slice());
        self.value.unwrap_or_else(value)
    }
}

impl Newton<'_> {
    /// Takes a step along a direction that is free of contact and decreases the potential. Returns false if
    /// there is none.
    pub(super) fn search(
        &self,
        steps: &mut VertexSteps,
        now: &mut Iterate<'_>,
        direction: &Direction<'_>,
        potential: &Potential<'_>,
        statistics: &mut Statistics,
    ) -> Result<bool, SimulationError> {
        let clock = Instant::now();
        let size = direction.size;
        let longest = (FARTHEST * self.system.extent() / size).min(1.0);
        let end = self.displaced(&now.positions, direction.displacements, longest);
        let surface = &self.system.geometry.mesh;
        // A direction that is not finite is rejected like one into a contact.
        let rejected = |_| self.blocked(None);
        let step = Step::new(surface, &now.positions, &end).map_err(rejected)?;
        let candidates = self.system.geometry.near(step, &self.barrier);
        let free = self
            .filter
            .free_part(&candidates, step, &self.system.geometry.min_distance);
        let free = free.min(self.system.geometry.free_of_half_spaces(step));
        if free <= 0.0 {
            let min_distance = &self.system.geometry.min_distance;
            return Err(self.blocked(self.filter.blocking_pair(&candidates, step, min_distance)));
        }
        let mut part = if free < 1.0 { SLACK * free } else { 1.0 };
        // Held coordinates rest, so that no vertex has to be pinned.
        let is_by_vertex = free < 1.0 && self.settings.line_search == LineSearch::Vertex;
        let end = is_by_vertex.then(|| steps.truncated(self.system, step, &[]));
        statistics.seconds.ccd += clock.elapsed().as_secs_f64();
        if let Some(end) = end.flatten()
            && let Some(taken) = self.search_to(now, &end, direction, part * longest, potential, statistics)
        {
            self.take(now, taken, statistics);
            return Ok(true);
        }

        let before = now.potential(potential);
        for _ in 0..HALVINGS {
            let clock = Instant::now();
            let along = step.at(part);
            let mut positions = along.clone();
            self.system.carriers.carry(&mut positions);
            // If the step is rounded to nothing, so are all shorter ones.
            if size > 0.0 && positions == now.positions {
                break;
            }
            let collisions = self.collisions(&candidates, &positions);
            let after = potential.value(&positions, collisions.as_slice());
            statistics.seconds.line_search += clock.elapsed().as_secs_f64();
            // An infinite potential, as of inverted elements, does not fall to an infinite one.
            let falls = after.is_finite() && after <= before
                || after.is_finite()
                    && after <= before + potential.noise(before)
                    && self.flattens(direction, potential, &positions, &collisions);
            if falls {
                let clock = Instant::now();
                // A full step is taken only if all of it is free.
                let free = part >= 1.0
                    || Step::new(surface, &now.positions, &positions)
                        .is_ok_and(|step| self.is_free_again(&candidates, step, &along));
                statistics.seconds.ccd += clock.elapsed().as_secs_f64();
                if free {
                    let taken = Taken {
                        positions,
                        collisions,
                        value: after,
                        size: part * longest,
                    };
                    self.take(now, taken, statistics);
                    return Ok(true);
                }
            }
            part *= 0.5;
        }
        statistics.step_sizes.push(0.0);
        Ok(false)
    }

    /// The error that every step is rejected, because of a pair.
    fn blocked(&self, pair: Option<Pair>) -> SimulationError {
        SimulationError::Blocked {
            step: self.times.step,
            filter: self.filter.name().to_owned(),
            pair: pair.map(|pair| BodyPrimitive::of_pair(self.system, pair)),
        }
    }

    /// Takes a step, and adapts the stiffness of the barrier.
    fn take(&self, now: &mut Iterate<'_>, taken: Taken, statistics: &mut Statistics) {
        let [before, after] = [&now.collisions, &taken.collisions].map(CollisionSet::minimal_distance);
        let stiffness = self.range.adapt(now.stiffness, before, after);
        now.value = (stiffness == now.stiffness).then_some(taken.value);
        now.stiffness = stiffness;
        now.positions = taken.positions;
        now.collisions = taken.collisions;
        statistics.step_sizes.push(taken.size);
    }

    /// Returns true if the slope of the potential along a direction is small enough at the new positions:
    /// the test of descent where rounding hides the difference of two values. This is the approximate Wolfe
    /// condition of W. Hager and H. Zhang, *A new conjugate gradient method with guaranteed descent and an
    /// efficient line search*, 2005.
    fn flattens(
        &self,
        direction: &Direction<'_>,
        potential: &Potential<'_>,
        positions: &[Point],
        collisions: &CollisionSet,
    ) -> bool {
        let before = direction.slope(direction.displacements);
        let gradient = potential.gradient(positions, collisions.as_slice());
        dot(&gradient, direction.displacements) <= -0.8 * before
    }

    /// Returns true if a step is free of contact: between surfaces by the filter, with half spaces exactly.
    pub(super) fn is_free(&self, candidates: &Candidates, step: Step<'_>) -> bool {
        let free = self
            .filter
            .is_free(candidates, step, &self.system.geometry.min_distance);
        free && self.system.geometry.first_grounded(step.positions()[1]).is_none()
    }

    /// Returns true if a part of a step is free of contact. `candidates` are the candidates of the whole
    /// step, and `along` are its positions at the end of the part.
    ///
    /// Carried vertices are rounded in another way. Where two primitives touch, each coordinate of their
    /// closest points then differs by at most the sum of both deviations more than along the step.
    /// `candidates` have all pairs within the activation distance: they suffice if each deviation is at most
    /// half of it. The test for a quarter leaves room for the rounding of the difference.
    fn is_free_again(&self, candidates: &Candidates, part: Step<'_>, along: &[Point]) -> bool {
        let [_, end] = part.positions();
        let coordinates = end.as_flattened().iter().zip(along.as_flattened());
        let deviation = coordinates.fold(0.0_f64, |largest, (a, b)| largest.max((a - b).abs()));
        if deviation <= 0.25 * self.barrier.activation_distance() {
            self.is_free(candidates, part)
        } else {
            self.is_free(&self.system.geometry.near(part, &self.barrier), part)
        }
    }

    /// The positions at a part of a direction.
    pub(super) fn displaced(&self, points: &[Point], direction: &[Vector3<f64>], size: f64) -> Vec<Point> {
        let along = |(x, d): (&Point, &Vector3<f64>)| (Vector3::from(*x) + d * size).into();
        let mut displaced: Vec<Point> = points.iter().zip(direction).map(along).collect();
        self.system.carriers.carry(&mut displaced);
        displaced
    }

    pub(super) fn collisions(&self, candidates: &Candidates, points: &[Point]) -> CollisionSet {
        CollisionSet::new(
            self.system.contact_surface(self.settings.formulation),
            candidates,
            points,
            self.barrier,
        )
    }
}
