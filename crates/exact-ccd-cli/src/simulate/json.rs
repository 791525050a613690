//! The output of `exact-ccd simulate --json`: one object on each line.

use exact_ccd_sim::{Simulation, Statistics};
use serde::Serialize;

use super::queries::Counts;
use super::statistics::Row;

/// The scene, before the first time step. Names end with units.
#[derive(Serialize)]
struct Scene {
    vertices: usize,
    faces: usize,
    rod_edges: usize,
    particles: usize,
    size_m: f64,
    contact_distance_m: f64,
    time_step_s: f64,
    /// The time step that the results have, and the last one to simulate.
    done: u64,
    steps: u64,
}

/// The line for a scene, simulated up to a time step.
pub(super) fn of_scene(simulation: &Simulation, steps: u64) -> String {
    let (system, settings) = (simulation.system(), simulation.settings());
    to_json(&Scene {
        vertices: system.start().len(),
        faces: system.surface().faces().len(),
        rod_edges: system.surface().loose_edges().len(),
        particles: system.particles().len(),
        size_m: system.size(),
        contact_distance_m: settings.contact_distance.meters(system.size()),
        time_step_s: settings.time_step,
        done: simulation.state().step,
        steps,
    })
}

/// The line for a time step: the columns of `statistics.csv`.
pub(super) fn of(statistics: &Statistics) -> String {
    to_json(&Row::from(statistics))
}

/// The numbers of queries of one kind.
#[derive(Serialize)]
struct Numbers {
    total: usize,
    in_contact: usize,
    kept: usize,
}

#[derive(Serialize)]
struct Queries {
    vertex_face: Numbers,
    edge_edge: Numbers,
}

/// The line for the queries of all time steps.
pub(super) fn of_queries(counts: &Counts<[usize; 3]>) -> String {
    let numbers = |[total, in_contact, kept]: [usize; 3]| Numbers {
        total,
        in_contact,
        kept,
    };
    to_json(&Queries {
        vertex_face: numbers(counts.vertex_face),
        edge_edge: numbers(counts.edge_edge),
    })
}

fn to_json(object: &impl Serialize) -> String {
    serde_json::to_string(object).expect("numbers and names only")
}
