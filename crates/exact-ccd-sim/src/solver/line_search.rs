//! How far a Newton iteration goes: as far as it is free of contact, and the potential falls.

use std::time::Instant;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::newton::{Iterate, Newton};
use super::potential::Potential;
use crate::contact::{Collisions, Pairs};
use crate::filter::Increment;
use crate::simulation::SimulationError;
use crate::statistics::Statistics;
use crate::system::System;

/// The part of the way to a contact that a step goes at most: what touches would have an infinite barrier.
const SLACK: f64 = 0.9;

/// How often a step is halved before it is given up.
const HALVINGS: usize = 60;

/// The farthest that a vertex goes in one iteration, in sizes of the scene. What goes farther is far from the minimum, and
/// would sweep over too many pairs.
const FARTHEST: f64 = 0.25;

impl Newton<'_> {
    /// Puts the scripted vertices to their targets: with the rest going along as Newton's method says, or else alone. If
    /// neither is free of contact, springs shall pull. Whether they are there.
    pub(super) fn prescribe(
        &self,
        now: &mut Iterate,
        direction: &[Vector3<f64>],
        potential: &Potential<'_>,
        statistics: &mut Statistics,
    ) -> bool {
        let mut together = displaced(&now.positions, direction, 1.0);
        let mut alone = now.positions.clone();
        for &(vertex, target) in now.dirichlet.targets() {
            together[vertex as usize] = target;
            alone[vertex as usize] = target;
        }
        let far = self.system.size() * FARTHEST;
        for end in [together, alone] {
            let pairs = zip(&now.positions, &end).map(|(a, b)| (b - a).amax());
            if pairs.fold(0.0, f64::max) > far {
                continue;
            }
            let clock = Instant::now();
            let pairs = self.pairs(&now.positions, &end);
            let increment = Increment::new(&self.system.surface, &pairs, &now.positions, &end);
            let free = self.filter.is_free(&increment, &end);
            statistics.seconds.ccd += clock.elapsed().as_secs_f64();
            if !free {
                continue;
            }
            let collisions = self.collisions(&pairs, &end);
            if potential.value(&end, &collisions).is_finite() {
                now.positions = end;
                now.collisions = collisions;
                now.dirichlet.reached();
                statistics.step_sizes.push(1.0);
                return true;
            }
        }
        statistics.step_sizes.push(0.0);
        now.dirichlet.stiffen(self.system);
        false
    }

    /// Goes along a direction, as far as it is free and the potential falls. Whether it goes anywhere.
    pub(super) fn search(
        &self,
        now: &mut Iterate,
        direction: &[Vector3<f64>],
        size: f64,
        potential: &Potential<'_>,
        statistics: &mut Statistics,
    ) -> Result<bool, SimulationError> {
        let clock = Instant::now();
        let longest = (FARTHEST * self.system.size() / size).min(1.0);
        let end = displaced(&now.positions, direction, longest);
        let pairs = self.pairs(&now.positions, &end);
        let increment = Increment::new(&self.system.surface, &pairs, &now.positions, &end);
        let free = self.filter.largest(&increment);
        statistics.seconds.ccd += clock.elapsed().as_secs_f64();
        if free <= 0.0 {
            return Err(SimulationError::Blocked {
                step: statistics.step,
                filter: self.filter.name().to_owned(),
            });
        }

        let before = potential.value(&now.positions, &now.collisions);
        let mut part = if free < 1.0 { SLACK * free } else { 1.0 };
        for _ in 0..HALVINGS {
            let clock = Instant::now();
            let positions = increment.at(part);
            // Rounded to where it begins: shorter steps are too.
            if size > 0.0 && positions == now.positions {
                break;
            }
            let collisions = self.collisions(&pairs, &positions);
            let after = potential.value(&positions, &collisions);
            statistics.seconds.line_search += clock.elapsed().as_secs_f64();
            let falls = after <= before
                || after <= before + potential.noise(before)
                    && self.flattens(now, direction, potential, &positions, &collisions);
            if falls {
                let clock = Instant::now();
                // The whole of a free step has been looked at already.
                let free = part >= 1.0 || self.filter.is_free(&increment, &positions);
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

    /// Whether the potential is less steep along a direction than where it begins: what decides where rounding hides
    /// whether it falls. This is the approximate Wolfe condition of W. Hager and H. Zhang, *A new conjugate gradient method
    /// with guaranteed descent and an efficient line search*, 2005.
    fn flattens(
        &self,
        now: &Iterate,
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
        let before = slope(potential.gradient(&now.positions, &now.collisions));
        slope(potential.gradient(positions, collisions)) <= -0.8 * before
    }

    fn pairs(&self, start: &[Point], end: &[Point]) -> Pairs {
        let distance = self.barrier.activation_distance_squared().sqrt();
        Pairs::near(&self.system.surface, start, end, distance)
    }

    fn collisions(&self, pairs: &Pairs, points: &[Point]) -> Collisions {
        let System { surface, start, .. } = self.system;
        Collisions::new(surface, pairs, points, start, self.barrier)
    }
}

fn displaced(points: &[Point], direction: &[Vector3<f64>], size: f64) -> Vec<Point> {
    let along = |(x, d): (&Point, &Vector3<f64>)| (Vector3::from(*x) + d * size).into();
    points.iter().zip(direction).map(along).collect()
}

fn zip<'a>(a: &'a [Point], b: &'a [Point]) -> impl Iterator<Item = (Vector3<f64>, Vector3<f64>)> + 'a {
    a.iter()
        .zip(b)
        .map(|(a, b)| (Vector3::from(*a), Vector3::from(*b)))
}
