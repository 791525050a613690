//! The statistics of a time step as a row of `statistics.csv`.

use exact_ccd_sim::{Energies, Statistics};
use serde::{Deserialize, Serialize};

use crate::contacts::unsigned_zero;

/// A row of `statistics.csv`. The names of the columns end with their units.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Row {
    /// The number of the time step, from 1.
    pub(crate) step: u64,
    /// The time at its end.
    #[serde(rename = "time_s")]
    pub(crate) time: f64,
    /// True if Newton's method reached its tolerance.
    pub(crate) converged: bool,
    /// The number of Newton iterations.
    pub(crate) iterations: usize,
    /// The least step size of a Newton iteration.
    pub(crate) step_size_min: Option<f64>,
    /// The mean step size.
    pub(crate) step_size_mean: Option<f64>,
    /// The number of pairs of features within the contact distance, at the end.
    pub(crate) contacts: usize,
    /// The least distance among these pairs. Empty if there are none.
    #[serde(rename = "minimal_distance_m")]
    pub(crate) minimal_distance: Option<f64>,
    /// The stiffness of the barrier. Empty before the first contact.
    #[serde(rename = "stiffness_kg_per_m2")]
    pub(crate) stiffness: Option<f64>,
    /// The greatest distance of a scripted vertex from its target.
    #[serde(rename = "script_lag_m")]
    pub(crate) script_lag: f64,
    #[serde(rename = "kinetic_J")]
    pub(crate) kinetic: f64,
    #[serde(rename = "elastic_J")]
    pub(crate) elastic: f64,
    #[serde(rename = "barrier_J")]
    pub(crate) barrier: f64,
    #[serde(rename = "friction_J")]
    pub(crate) friction: f64,
    #[serde(rename = "gravity_J")]
    pub(crate) gravity: f64,
    #[serde(rename = "assembly_s")]
    pub(crate) assembly: f64,
    #[serde(rename = "solve_s")]
    pub(crate) solve: f64,
    #[serde(rename = "ccd_s")]
    pub(crate) ccd: f64,
    #[serde(rename = "line_search_s")]
    pub(crate) line_search: f64,
    #[serde(rename = "total_s")]
    pub(crate) total: f64,
}

impl Row {
    pub(crate) fn energies(&self) -> Energies {
        Energies {
            kinetic: self.kinetic,
            elastic: self.elastic,
            barrier: self.barrier,
            friction: self.friction,
            gravity: self.gravity,
        }
    }
}

impl From<&Statistics> for Row {
    fn from(statistics: &Statistics) -> Self {
        let Statistics {
            energies, seconds, ..
        } = statistics;
        let sizes = &statistics.step_sizes;
        Self {
            step: statistics.step,
            time: statistics.time,
            converged: statistics.converged,
            iterations: statistics.iterations,
            step_size_min: sizes.iter().copied().reduce(f64::min),
            step_size_mean: (!sizes.is_empty()).then(|| sizes.iter().sum::<f64>() / sizes.len() as f64),
            contacts: statistics.contacts,
            minimal_distance: statistics.minimal_distance,
            stiffness: statistics.stiffness,
            script_lag: statistics.script_lag,
            kinetic: unsigned_zero(energies.kinetic),
            elastic: unsigned_zero(energies.elastic),
            barrier: unsigned_zero(energies.barrier),
            friction: unsigned_zero(energies.friction),
            gravity: unsigned_zero(energies.gravity),
            assembly: seconds.assembly,
            solve: seconds.solve,
            ccd: seconds.ccd,
            line_search: seconds.line_search,
            total: seconds.total,
        }
    }
}
