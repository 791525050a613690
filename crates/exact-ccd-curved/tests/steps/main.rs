//! Steps of meshes whose vertices move on curves.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod bodies;
mod errors;
mod gears;
mod polynomials;
mod straight;

use exact_ccd::Separation;
use exact_ccd_curved::{CurvedStep, CurvedStepOptions, Instances, SearchOptions, curved_step};

fn within(d: f64) -> Separation {
    Separation::new(d).unwrap()
}

fn step(instances: &Instances, d: f64, tolerance: f64) -> CurvedStep {
    let options = CurvedStepOptions::default()
        .with_can_collide(instances.can_collide())
        .with_search(SearchOptions::default().with_time_tolerance(tolerance));
    curved_step(&instances.mesh, &instances.trajectories, within(d), &options).unwrap()
}
