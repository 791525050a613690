//! The output of `exact-ccd simulate --json`: one object on each line.

use exact_ccd_sim::{Simulation, Statistics};
use serde::Serialize;
use serde_json::{Map, Value};

use crate::commands::simulate::folder::statistics::Row;
use crate::text::json::to_json;

/// The scene, before the first time step. Names end with units.
#[derive(Serialize)]
struct SceneLine {
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
pub(crate) fn of_scene(simulation: &Simulation, steps: u64) -> String {
    let (system, settings) = (simulation.system(), simulation.settings());
    to_json(
        "simulate",
        &SceneLine {
            vertices: system.mesh_vertices().len(),
            faces: system.surface().faces().len(),
            rod_edges: system.surface().loose_edges().len(),
            particles: system.particles().len(),
            size_m: system.size(),
            contact_distance_m: settings.contact_distance.meters(system.size()),
            time_step_s: settings.time_step,
            done: simulation.state().step,
            steps,
        },
    )
}

/// A time step: the columns of `statistics.csv`, with the durations apart.
#[derive(Serialize)]
struct StepLine {
    #[serde(flatten)]
    columns: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    seconds: Map<String, Value>,
}

/// The line for a time step.
pub(crate) fn of_step(statistics: &Statistics, no_seconds: bool) -> String {
    let row = serde_json::to_value(Row::from(statistics)).expect("numbers only");
    let columns = row.as_object().into_iter().flatten();
    let mut step = StepLine {
        columns: Map::new(),
        seconds: Map::new(),
    };
    for (name, value) in columns {
        match name.strip_suffix("_s").filter(|_| name != "time_s") {
            Some(phase) if !no_seconds => step.seconds.insert(phase.to_owned(), value.clone()),
            Some(_) => None,
            None => step.columns.insert(name.clone(), value.clone()),
        };
    }
    to_json("simulate", &step)
}
