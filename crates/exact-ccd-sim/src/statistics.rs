//! What a step took.

use serde::{Deserialize, Serialize};

/// A report on one time step.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Statistics {
    /// The number of the step, from 1.
    pub step: u64,
    /// The time at its end, in s.
    pub time: f64,
    /// Whether Newton's method reached its tolerance, for each lag of friction.
    pub converged: bool,
    /// How many iterations it took, over all lags of friction.
    pub iterations: usize,
    /// What part of each direction was taken.
    pub step_sizes: Vec<f64>,
    /// How many pairs of features are within the contact distance, at the end: each once, however many pairs of primitives
    /// have it in common.
    pub contacts: usize,
    /// The least distance, in m, or `None` if nothing is within the contact distance.
    pub minimal_distance: Option<f64>,
    /// The stiffness of the barrier, in kg/m², once there has been contact.
    pub stiffness: Option<f64>,
    /// How far the scripted vertex that lags most is from where its script says, in m.
    pub script_lag: f64,
    /// The energies at the end.
    pub energies: Energies,
    /// Where the time went.
    pub seconds: Seconds,
}

/// Energies in J.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Energies {
    /// Of motion.
    pub kinetic: f64,
    /// Of deformation.
    pub elastic: f64,
    /// Of contact: the barrier, as a potential.
    pub barrier: f64,
    /// What friction dissipated in the step: the sum of μ N f₁ times how far it slipped, with the velocities at the end.
    pub friction: f64,
    /// Of gravity, relative to the origin.
    pub gravity: f64,
}

impl Energies {
    /// The sum of those that are conserved without dissipation: all but friction.
    #[must_use]
    pub fn mechanical(&self) -> f64 {
        self.kinetic + self.elastic + self.barrier + self.gravity
    }
}

/// Times in s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Seconds {
    /// Gradients, Hessians and their sum.
    pub assembly: f64,
    /// The sparse factorisation and solution.
    pub solve: f64,
    /// Finding pairs, and how far they may go.
    pub ccd: f64,
    /// Energies along the direction.
    pub line_search: f64,
    /// All of the step.
    pub total: f64,
}
