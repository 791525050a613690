//! Projected Newton with a line search that is filtered by CCD.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::couplings::Couplings;
use super::direction::Direction;
use super::linear::LinearSolver;
use super::potential::{Potential, Terms};
use super::stagnation::Stagnation;
use super::unknowns::Unknowns;
use super::vertex_steps::VertexSteps;
use crate::energies::contact::{Barrier, CollisionSet, StiffnessRange};
use crate::energies::elasticity::Twist;
use crate::error::SimulationError;
use crate::filter::StepFilter;
use crate::iteration::{Iteration, Watch};
use crate::prescribed::Axes;
use crate::prescribed::{Dirichlet, HeldChains, Times};
use crate::settings::Settings;
use crate::statistics::Statistics;
use crate::system::{Designation, System};

/// The minimisation of the incremental potential of one part of a time step.
pub(crate) struct Newton<'a> {
    pub(crate) system: &'a System,
    pub(crate) settings: &'a Settings,
    pub(crate) filter: &'a StepFilter,
    pub(crate) barrier: Barrier,
    pub(crate) range: StiffnessRange,
    pub(crate) times: Times,
    /// The coordinates of each vertex that are not free.
    pub(crate) held: Vec<Axes>,
    pub(crate) chains: HeldChains<'a>,
    pub(crate) terms: Terms,
    pub(crate) interrupt: &'a AtomicBool,
    pub(crate) watch: Option<&'a Watch>,
}

/// The memory of a minimisation, for the next one of the same system. No result depends on it.
#[derive(Default)]
pub(crate) struct Memory {
    couplings: Option<Couplings>,
    linear: LinearSolver,
    steps: VertexSteps,
}

/// An iterate of Newton's method.
pub(crate) struct Iterate<'a> {
    pub(crate) positions: Vec<Point>,
    pub(crate) collisions: CollisionSet,
    /// The value of the potential here, if the line search before found it.
    pub(crate) value: Option<f64>,
    /// κ.
    pub(crate) stiffness: f64,
    pub(crate) dirichlet: Dirichlet<'a>,
}

/// The size of a direction, relative to the size of the scene, from which rounding errors cannot be its
/// cause.
const SHORT: f64 = 1e-6;

impl Newton<'_> {
    /// Minimises the potential from an iterate. Returns true if it converges.
    ///
    /// Newton stops when the largest component of the direction and the predicted decrease of energy are
    /// below the tolerance.
    pub(crate) fn minimise(
        &self,
        memory: &mut Memory,
        now: &mut Iterate<'_>,
        statistics: &mut Statistics,
        visit: &mut dyn FnMut(&[Point]),
    ) -> Result<bool, SimulationError> {
        let mass = self.system.free_mass();
        let unknowns = &Unknowns::new(&self.held);
        let tolerance = self.settings.newton_tolerance(self.system.size());
        // The terms of the last minimisation can be others.
        now.value = None;
        let mut stagnation = Stagnation::default();
        for iteration in 0..self.settings.max_iterations {
            if self.interrupt.load(Ordering::Relaxed) {
                let step = self.times.step;
                return Err(SimulationError::Interrupted { step });
            }
            let clock = Instant::now();
            let twists = self.chains.twists(&now.dirichlet);
            let potential = self.potential(now.stiffness, &twists);
            let couplings = Couplings::kept(&mut memory.couplings, self.system, &twists, unknowns);
            // The first system of a minimisation has its own pattern, so that no result depends on earlier
            // minimisations.
            let earlier = memory.linear.pattern().filter(|_| iteration > 0);
            let prescribed = now.dirichlet.displacements(&now.positions);
            let quadratic = potential.quadratic(
                &now.positions,
                now.collisions.as_slice(),
                unknowns,
                couplings,
                &prescribed,
                earlier,
            );
            let right = quadratic.right(unknowns);
            statistics.seconds.assembly += clock.elapsed().as_secs_f64();

            let clock = Instant::now();
            let solution = memory.linear.solve(quadratic.pattern, quadratic.values, &right);
            let solution = solution.ok_or_else(|| SimulationError::Singular {
                step: self.times.step,
                body: self.most_loaded(unknowns, &right),
            })?;
            statistics.seconds.solve += clock.elapsed().as_secs_f64();

            let mut direction = prescribed;
            for (&vertex, part) in unknowns.vertices().iter().zip(solution.chunks_exact(3)) {
                direction[vertex as usize] += Vector3::from_column_slice(part);
            }
            self.system.carriers.carry(&mut direction);
            statistics.iterations += 1;
            let size = direction.iter().fold(0.0_f64, |size, part| size.max(part.amax()));
            if let Some(watch) = self.watch {
                watch(&Iteration {
                    step: self.times.step,
                    part: self.times.part,
                    iteration: statistics.iterations,
                    residual: size / self.terms.duration,
                    tolerance,
                    contacts: now.collisions.count(),
                });
            }
            if now.dirichlet.is_prescribed() {
                now.value = None;
                if self.prescribe(&mut memory.steps, now, &direction, &potential, statistics) {
                    visit(&now.positions);
                }
                continue;
            }
            // Twice the predicted decrease of the potential. Deep in the barrier, even a short step can
            // release much energy. The step counts as small only if this energy is at most the kinetic
            // energy of all free masses at the tolerance.
            let decrease: f64 = right.iter().zip(&solution).map(|(a, b)| a * b).sum();
            let length = tolerance * self.terms.duration;
            let is_small = size <= length && decrease <= mass * length * length;
            let stiffness = now.stiffness;
            let step = Direction {
                displacements: &direction,
                size,
                gradient: &quadratic.gradient,
                decrease,
            };
            let moved = self.search(&mut memory.steps, now, &step, &potential, statistics)?;
            if moved {
                visit(&now.positions);
            }
            let is_short = size <= SHORT * self.system.size();
            let is_lost = !is_small && is_short && decrease <= potential.noise(now.potential(&potential));
            let is_idle = !is_small && stagnation.is_reached(size, is_lost);
            // After an increase of κ, the iterate is not a minimum of the new potential.
            let is_done = !moved || is_idle || is_small && now.stiffness == stiffness;
            if is_done {
                if !now.dirichlet.resume() {
                    statistics.stagnated |= is_lost;
                    return Ok(is_small);
                }
                stagnation = Stagnation::default();
            }
        }
        Ok(false)
    }

    /// The potential with a stiffness κ and the twists of chains.
    pub(crate) fn potential<'b>(&'b self, stiffness: f64, twists: &'b [Twist]) -> Potential<'b> {
        Potential {
            system: self.system,
            terms: &self.terms,
            stiffness,
            twists,
        }
    }

    /// The body of the vertex with the largest force, or with one that is not finite.
    fn most_loaded(&self, unknowns: &Unknowns, forces: &[f64]) -> Designation {
        let sizes = forces.iter().map(|force| force.abs()).enumerate();
        // NaN is above all numbers.
        let largest = sizes.max_by(|(_, a), (_, b)| a.total_cmp(b));
        let vertex = largest.map_or(0, |(place, _)| unknowns.vertices()[place / 3]);
        self.system.bodies.designation(self.system.bodies.of(vertex))
    }
}
