//! One time step.

use std::collections::BTreeSet;
use std::time::Instant;

use exact_ccd_mesh::Point;

use super::Simulation;
use super::known::KnownCollisions;
use super::problem::Problem;
use crate::error::SimulationError;
use crate::integrator::Integrator;
use crate::prescribed::{Paths, Times};
use crate::state::State;
use crate::statistics::{Seconds, Statistics};

/// The part of a time step by which the scripts of a body fall behind if it does not move.
const STUCK: f64 = 0.99;

impl Simulation {
    /// Takes one time step. An error leaves the state unchanged.
    ///
    /// # Errors
    /// [`SimulationError::Singular`], [`SimulationError::Blocked`] and [`SimulationError::Interrupted`].
    pub fn step(&mut self) -> Result<Statistics, SimulationError> {
        self.step_along(&mut |_| ())
    }

    /// Takes one time step, and calls `visit` with all positions after each accepted Newton step.
    ///
    /// The filter applies to these increments, in which all vertices move in straight lines. The straight
    /// motion from the start of the time step to its end is a different one, which may have contacts.
    ///
    /// If Newton's method does not converge or fails, the time step is repeated in twice as many parts of
    /// equal duration, up to [`max_substeps`](crate::Settings::max_substeps), unless rounding errors are the
    /// cause. A time step of BDF2 in which
    /// bodies begin or cease to touch is repeated as one of implicit Euler. Only the increments of the last
    /// attempt are visited, when it ends.
    ///
    /// # Errors
    /// As [`Simulation::step`].
    pub fn step_along(
        &mut self,
        visit: &mut (dyn FnMut(&[Point]) + Send),
    ) -> Result<Statistics, SimulationError> {
        // The whole step runs on a thread of the pool: each parallel call from outside the pool would cost a
        // context switch.
        rayon::scope(|_| self.attempts(visit))
    }

    fn attempts(&mut self, visit: &mut dyn FnMut(&[Point])) -> Result<Statistics, SimulationError> {
        let start = self.state.clone();
        let touching = (self.settings.integrator == Integrator::Bdf2).then(|| self.touching());
        let (mut parts, mut seconds, mut is_impact) = (1, Seconds::default(), false);
        loop {
            let is_last = 2 * parts > self.settings.max_substeps;
            let mut increments = Vec::new();
            let mut visit_later = |positions: &[Point]| increments.push(positions.to_vec());
            let found = match self.substeps(parts, !is_last, &mut visit_later) {
                Err(SimulationError::Singular { .. } | SimulationError::Blocked { .. }) if !is_last => None,
                Err(error) => {
                    self.state = start;
                    return Err(error);
                }
                Ok(statistics) => {
                    seconds = seconds.plus(&statistics.seconds);
                    let is_whole = self.state.step > start.step;
                    let is_stuck = || is_whole && self.is_stuck_since(&start);
                    let is_final = statistics.stagnated && is_whole;
                    let is_taken = statistics.converged || is_final || is_last || is_stuck();
                    is_taken.then_some(statistics)
                }
            };
            let is_smooth = || touching.as_ref().is_none_or(|before| *before == self.touching());
            match found {
                None => parts *= 2,
                // Parts were steps of implicit Euler already.
                Some(statistics) if is_impact || parts > 1 || is_smooth() => {
                    if is_impact {
                        self.state.earlier = None;
                    }
                    increments.iter().for_each(|positions| visit(positions));
                    return Ok(Statistics {
                        converged: statistics.converged && self.state.behind.is_empty(),
                        seconds,
                        ..statistics
                    });
                }
                Some(_) => is_impact = true,
            }
            self.state = start.clone();
            if is_impact {
                self.state.earlier = None;
            }
        }
    }

    /// Returns true if a body with a script has not moved since a state one time step before, because
    /// something is in its way. Shorter time steps would not move it either.
    fn is_stuck_since(&self, start: &State) -> bool {
        let least = STUCK * self.settings.time_step;
        let mut late = self.state.behind.iter();
        late.any(|(body, behind)| behind - start.behind.get(body).unwrap_or(&0.0) > least)
    }

    /// The pairs of bodies and half spaces in contact.
    fn touching(&self) -> BTreeSet<[usize; 2]> {
        self.contacts().iter().map(|contact| contact.bodies).collect()
    }

    /// Takes one time step in parts of equal duration. If `convergent`, ends after a part that does not
    /// converge, within the time step unless that is the last part. After an error, the state is that after
    /// the parts before.
    fn substeps(
        &mut self,
        parts: usize,
        convergent: bool,
        visit: &mut dyn FnMut(&[Point]),
    ) -> Result<Statistics, SimulationError> {
        let step = self.state.step;
        let mut sum: Option<Statistics> = None;
        for part in 1..=parts {
            // BDF2 needs equal time steps: parts are steps of implicit Euler.
            if parts > 1 {
                self.state.earlier = None;
            }
            let times = Times::new(step, self.settings.time_step, [part, parts]);
            let statistics = self.advance(times, convergent, visit)?;
            let ends_early = convergent && !statistics.converged && part < parts;
            let statistics = match sum {
                None => statistics,
                Some(before) => before.followed_by(statistics),
            };
            if ends_early {
                return Ok(statistics);
            }
            sum = Some(statistics);
        }
        if parts > 1 {
            self.state.earlier = None;
        }
        self.state.step = step + 1;
        Ok(sum.unwrap_or_default())
    }

    /// Takes one part of a time step. If `convergent`, ends with the first lag of friction that does not
    /// converge.
    fn advance(
        &mut self,
        times: Times,
        convergent: bool,
        visit: &mut dyn FnMut(&[Point]),
    ) -> Result<Statistics, SimulationError> {
        let clock = Instant::now();
        let mut memory = std::mem::take(&mut self.memory);
        let paths = Paths::new(&self.system, &self.state, times);
        let mut problem = Problem::new(self, &paths);
        let mut now = problem.first();
        let mut statistics = problem.minimise(&mut memory, &mut now, convergent, visit)?;
        let (state, collisions) = problem.record(now, &mut statistics);
        self.known = Some(KnownCollisions {
            positions: state.positions.clone(),
            collisions,
        });
        self.state = state;
        self.memory = memory;
        statistics.seconds.total = clock.elapsed().as_secs_f64();
        Ok(statistics)
    }
}
