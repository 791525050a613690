//! The lines of the answer, one for the scene and one for each time step, as text or JSON.

pub(super) mod convergence;
mod json;
mod significant;
pub(super) mod text;

use exact_ccd_sim::{Simulation, Statistics};

use super::queries::Counts;
use crate::text::json::to_json;

/// The form of the lines on the command line.
#[derive(clap::Args)]
pub(super) struct Lines {
    /// Print a JSON object in place of each line of text. docs/reports.md has its schema.
    #[arg(long)]
    json: bool,
    /// Leave the durations out, so that the lines have the same bytes each time.
    #[arg(long)]
    no_seconds: bool,
}

impl Lines {
    /// The line for a scene, simulated up to a time step. `last` is the number of the last time step.
    pub(super) fn of_scene(&self, simulation: &Simulation, last: u64, is_saved: bool) -> String {
        if self.json {
            json::of_scene(simulation, last)
        } else {
            text::of_scene(simulation, last, is_saved)
        }
    }

    /// The line for a time step.
    pub(super) fn of_step(&self, statistics: &Statistics) -> String {
        if self.json {
            json::of_step(statistics, self.no_seconds)
        } else {
            text::of_step(statistics, self.no_seconds)
        }
    }

    /// The line for the queries of all time steps.
    pub(super) fn of_queries(&self, counts: &Counts) -> String {
        if self.json {
            to_json("simulate", counts)
        } else {
            text::of_queries(counts)
        }
    }
}
