//! Projected Newton with a line search that is filtered by continuous collision detection.

use std::time::Instant;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::linear::LinearSolver;
use super::potential::Potential;
use super::unknowns::Unknowns;
use crate::contact::{Barrier, Collisions, StiffnessRange};
use crate::drive::Drive;
use crate::filter::StepFilter;
use crate::friction::{FrictionContact, Smoothing};
use crate::integrator::Scheme;
use crate::simulation::SimulationError;
use crate::statistics::Statistics;
use crate::system::System;

/// What stays the same while a potential is minimised.
pub(crate) struct Newton<'a> {
    pub(crate) system: &'a System,
    pub(crate) scheme: &'a Scheme,
    pub(crate) friction: &'a [FrictionContact],
    pub(crate) smoothing: Smoothing,
    pub(crate) barrier: Barrier,
    pub(crate) range: StiffnessRange,
    pub(crate) filter: &'a dyn StepFilter,
    /// In m/s.
    pub(crate) tolerance: f64,
    pub(crate) max_iterations: usize,
}

/// What changes.
pub(crate) struct Outcome {
    pub(crate) positions: Vec<Point>,
    pub(crate) collisions: Collisions,
    /// κ.
    pub(crate) stiffness: f64,
    pub(crate) drive: Drive,
}

impl Newton<'_> {
    /// Minimises the potential from where things are. Whether it converges.
    pub(crate) fn minimise(
        &self,
        solver: &mut LinearSolver,
        now: &mut Outcome,
        statistics: &mut Statistics,
        visit: &mut dyn FnMut(&[Point]),
    ) -> Result<bool, SimulationError> {
        let mass = self.system.free_mass();
        let mut plan: Option<(Unknowns, Vec<u64>)> = None;
        for _ in 0..self.max_iterations {
            let clock = Instant::now();
            let springs = now.drive.springs();
            let potential = Potential {
                system: self.system,
                scheme: self.scheme,
                stiffness: now.stiffness,
                friction: self.friction,
                smoothing: self.smoothing,
                springs: &springs,
            };
            let unknowns = self.unknowns(&now.drive);
            if plan.as_ref().is_none_or(|(before, _)| *before != unknowns) {
                let keys = potential.elastic_keys(&unknowns);
                plan = Some((unknowns, keys));
            }
            let Some((unknowns, keys)) = &plan else { continue };

            let given = self.given(now);
            let quadratic = potential.quadratic(&now.positions, &now.collisions, unknowns, keys, &given);
            let right: Vec<f64> = unknowns
                .vertices()
                .iter()
                .flat_map(|&v| {
                    <[f64; 3]>::from(-quadratic.gradient[v as usize] - quadratic.given[v as usize])
                })
                .collect();
            statistics.seconds.assembly += clock.elapsed().as_secs_f64();

            let clock = Instant::now();
            let solution = solver.solve(quadratic.pattern, quadratic.values, &right);
            let solution = solution.ok_or(SimulationError::Singular {
                step: statistics.step,
            })?;
            statistics.seconds.solve += clock.elapsed().as_secs_f64();

            let mut direction = given;
            for (&vertex, part) in unknowns.vertices().iter().zip(solution.chunks_exact(3)) {
                direction[vertex as usize] = Vector3::from_column_slice(part);
            }
            statistics.iterations += 1;
            if now.drive.is_putting() {
                if self.put(now, &direction, &potential, statistics) {
                    visit(&now.positions);
                }
                continue;
            }
            let size = direction.iter().fold(0.0_f64, |size, part| size.max(part.amax()));
            // Twice what the quadratic falls by. Deep in the barrier, a short step may still set much energy free: it counts as
            // small only if that is no more than the kinetic energy of all free masses at the tolerance.
            let decrease: f64 = right.iter().zip(&solution).map(|(a, b)| a * b).sum();
            let length = self.tolerance * self.scheme.duration;
            let is_small = size <= length && decrease <= mass * length * length;
            let stiffness = now.stiffness;
            let moved = self.search(now, &direction, size, &potential, statistics)?;
            if moved {
                visit(&now.positions);
            }
            // A barrier that has just been made stiffer makes another potential, of which this is not the minimum.
            let is_done = !moved || is_small && now.stiffness == stiffness;
            if is_done && now.drive.is_pulling() {
                now.drive.put();
            } else if is_done {
                return Ok(is_small);
            }
        }
        Ok(false)
    }

    fn unknowns(&self, drive: &Drive) -> Unknowns {
        let mut unknown: Vec<bool> = (0..self.system.start.len())
            .map(|v| self.system.is_free(v))
            .collect();
        if drive.is_pulling() {
            for &(vertex, _) in drive.targets() {
                unknown[vertex as usize] = true;
            }
        }
        Unknowns::new(&unknown)
    }

    /// The displacements of the vertices that are put to their targets.
    fn given(&self, now: &Outcome) -> Vec<Vector3<f64>> {
        let mut given = vec![Vector3::zeros(); now.positions.len()];
        if now.drive.is_putting() {
            for &(vertex, target) in now.drive.targets() {
                let vertex = vertex as usize;
                given[vertex] = Vector3::from(target) - Vector3::from(now.positions[vertex]);
            }
        }
        given
    }
}
