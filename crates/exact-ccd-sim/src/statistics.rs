//! Statistics of a time step.

use serde::{Deserialize, Serialize};

/// The statistics of one time step.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Statistics {
    /// The number of the step, from 1.
    pub step: u64,
    /// The time at its end, in s.
    pub time: f64,
    /// True if Newton's method reached its tolerance for every friction lag, and all scripted vertices their
    /// targets.
    pub converged: bool,
    /// True if rounding errors kept Newton's method from its tolerance: time steps in parts do not help, but
    /// a larger tolerance does.
    pub stagnated: bool,
    /// The number of Newton iterations, over all friction lags.
    pub iterations: usize,
    /// The accepted step size of each iteration, as a fraction of the Newton direction. 0 if no step was
    /// accepted.
    pub step_sizes: Vec<f64>,
    /// The number of collisions at the end: pairs of features within the contact distance. A pair of
    /// features counts once, even if several pairs of primitives share it.
    pub contacts: usize,
    /// The least distance at the end between two surfaces, which are offset from their meshes, in m. `None`
    /// if there is no collision.
    pub minimal_distance: Option<f64>,
    /// The stiffness κ of the barrier, in kg/m². `None` before the first contact.
    pub stiffness: Option<f64>,
    /// The greatest distance of a scripted vertex from its target, in m.
    pub script_lag: f64,
    /// The energies at the end.
    pub energies: Energies,
    /// Run times.
    pub seconds: Seconds,
}

impl Statistics {
    /// The statistics of two parts of a time step together.
    pub(crate) fn followed_by(mut self, next: Self) -> Self {
        self.step_sizes.extend(next.step_sizes);
        Self {
            converged: self.converged && next.converged,
            stagnated: self.stagnated || next.stagnated,
            iterations: self.iterations + next.iterations,
            step_sizes: self.step_sizes,
            energies: Energies {
                friction: self.energies.friction + next.energies.friction,
                ..next.energies
            },
            seconds: self.seconds.plus(&next.seconds),
            ..next
        }
    }
}

/// Energies in J. See [`Integrator`](crate::Integrator) for their conservation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Energies {
    /// The kinetic energy.
    pub kinetic: f64,
    /// The elastic energy.
    pub elastic: f64,
    /// The energy of the barrier.
    pub barrier: f64,
    /// The energy that friction dissipated in the step: the sum of μ λ f₁ times the slip, with the
    /// velocities at the end.
    pub friction: f64,
    /// The potential energy of gravity, relative to the origin.
    pub gravity: f64,
}

impl Energies {
    /// The mechanical energy: the sum of all energies except for the dissipation of friction.
    #[must_use]
    pub fn mechanical(&self) -> f64 {
        self.kinetic + self.elastic + self.barrier + self.gravity
    }
}

/// Run times in s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Seconds {
    /// Assembly of gradients and Hessians.
    pub assembly: f64,
    /// Sparse factorisation and solution.
    pub solve: f64,
    /// Broad phase and CCD.
    pub ccd: f64,
    /// Energies along the Newton direction.
    pub line_search: f64,
    /// The whole step.
    pub total: f64,
}

impl Seconds {
    /// The sums of run times.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self {
            assembly: self.assembly + other.assembly,
            solve: self.solve + other.solve,
            ccd: self.ccd + other.ccd,
            line_search: self.line_search + other.line_search,
            total: self.total + other.total,
        }
    }
}
