//! The page of a simulation.

mod history;

use std::io;
use std::path::Path;

use exact_ccd_scene::Rendering;
use exact_ccd_sim::{Simulation, Statistics};
use exact_ccd_view::Body;

use super::View;
use super::recording::Recording;
use super::setup::Setup;
use crate::files::inputs::name;
use crate::messages::failure::Failure;

/// A simulation that is recorded for its page, if there is to be one.
pub(crate) struct SimulationPage {
    frames: Recording,
    /// The time of the first frame, and the time steps after it.
    start: f64,
    steps: Vec<Statistics>,
}

impl View {
    /// The recording of a simulation, which does nothing if there is to be no page of it.
    pub(crate) fn simulation(
        &self,
        file: &Path,
        simulation: &Simulation,
        rendering: &Rendering,
    ) -> SimulationPage {
        let upwards = rendering.upwards(simulation.settings().gravity);
        let setup = || setup(simulation).with_up(self.view_up.or(Some(upwards)));
        SimulationPage {
            frames: Recording::new(self.view.clone(), name(file), setup),
            start: 0.0,
            steps: Vec::new(),
        }
    }
}

fn setup(simulation: &Simulation) -> Setup {
    let system = simulation.system();
    let bodies = system.surface_bodies().into_iter().zip(system.body_kinds());
    Setup {
        bodies: bodies
            .map(|((name, vertices), kind)| Body::new(name, *kind, vertices))
            .collect(),
        half_spaces: system.half_spaces().to_vec(),
        radii: system.surface_offsets(),
        ..Setup::default()
    }
}

impl SimulationPage {
    /// Adds the surface in the state of a simulation, with the statistics of the time step that led to it.
    pub(crate) fn add_state(
        &mut self,
        simulation: &Simulation,
        step: Option<&Statistics>,
    ) -> Result<(), Failure> {
        let Some(file) = self.frames.file() else {
            return Ok(());
        };
        let surface = simulation.system().surface_frame(&simulation.state().positions);
        let frame = surface.map_err(|error| Failure::write(file, io::Error::other(error)))?;
        // Without the rounding errors of multiples of the time step.
        let time = (1e9 * simulation.time()).round() / 1e9;
        match step {
            Some(step) => self.steps.push(step.clone()),
            None => self.start = time,
        }
        self.frames.begin(&frame.mesh, || frame.bounds());
        self.frames.add(&format!("{time} s"), &frame.positions)
    }

    /// Writes the page, with charts of the time steps: a verdict about all of them, and lines about the
    /// scene. `contact_distance` is d̂, in m.
    pub(crate) fn finish(self, verdict: &str, scene: &str, contact_distance: f64) -> Result<(), Failure> {
        let history = history::of(self.start, &self.steps, contact_distance);
        self.frames.with_history(history).finish(verdict, scene)
    }
}
