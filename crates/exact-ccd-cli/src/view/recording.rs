//! The page of a motion whose frames come one after the other.

use std::io;
use std::path::{Path, PathBuf};

use exact_ccd_mesh::{Frame, Violation};
use exact_ccd_sim::{Simulation, Statistics};
use exact_ccd_view::Page;

use super::history;
use super::setup::Setup;
use crate::failure::Failure;

/// A motion that is recorded for its page, if there is to be one.
pub(crate) struct Recording {
    file: Option<PathBuf>,
    title: String,
    /// The contents of the page, until it begins.
    setup: Setup,
    page: Option<Page>,
    /// The time of the first frame of a simulation, and the time steps after it.
    start: f64,
    steps: Vec<Statistics>,
}

impl Recording {
    /// The recording for a page in a file; `setup` is not called if there is to be none.
    pub(super) fn new(file: Option<PathBuf>, title: String, setup: impl FnOnce() -> Setup) -> Self {
        Self {
            setup: if file.is_some() { setup() } else { Setup::default() },
            file,
            title,
            page: None,
            start: 0.0,
            steps: Vec::new(),
        }
    }

    /// Adds the next frame, from a file.
    pub(crate) fn add(&mut self, name: &str, frame: &Frame) -> Result<(), Failure> {
        if self.file.is_none() {
            return Ok(());
        }
        self.push(&super::name(Path::new(name)), frame)
    }

    /// Adds the surface in the state of a simulation, with the statistics of the time step that led to it.
    pub(crate) fn add_state(
        &mut self,
        simulation: &Simulation,
        step: Option<&Statistics>,
    ) -> Result<(), Failure> {
        let Some(file) = &self.file else { return Ok(()) };
        let surface = simulation.system().surface_frame(&simulation.state().positions);
        let frame = surface.map_err(|error| Failure::write(file, io::Error::other(error)))?;
        // Without the rounding errors of multiples of the time step.
        let time = (1e9 * simulation.time()).round() / 1e9;
        match step {
            Some(step) => self.steps.push(step.clone()),
            None => self.start = time,
        }
        self.push(&format!("{time} s"), &frame)
    }

    fn push(&mut self, label: &str, frame: &Frame) -> Result<(), Failure> {
        let page = match &mut self.page {
            Some(page) => page,
            none => none.insert(std::mem::take(&mut self.setup).page(&self.title, frame)),
        };
        Ok(page.add_frame(label, &frame.positions)?)
    }

    /// Adds a violation in the last frame, or in the step that leads to it.
    pub(crate) fn violation(&mut self, violation: &Violation) -> Result<(), Failure> {
        let Some(page) = &mut self.page else { return Ok(()) };
        let added = match violation {
            Violation::Intersection { intersection, .. } => page.add_intersection(*intersection),
            Violation::Contact { contact, .. } => page.add_contact(contact),
        };
        Ok(added?)
    }

    /// Adds a vertex that is not apart from the half space of this number in the last frame.
    pub(crate) fn half_space_contact(&mut self, vertex: u32, half_space: u32) -> Result<(), Failure> {
        let Some(page) = &mut self.page else { return Ok(()) };
        Ok(page.add_half_space_contact(vertex, half_space, None)?)
    }

    /// Writes the page, with the answer that was printed, of which one line is the verdict.
    pub(crate) fn finish(self, verdict: &str, answer: &str) -> Result<(), Failure> {
        match (self.file, self.page) {
            (Some(file), Some(page)) => super::write(&file, &super::with_answer(page, verdict, answer)),
            _ => Ok(()),
        }
    }

    /// Writes the page of a simulation, with charts of its time steps: a verdict about all of them, and lines
    /// about the scene. `contact_distance` is d̂, in m.
    pub(crate) fn finish_simulation(
        mut self,
        verdict: &str,
        scene: &str,
        contact_distance: f64,
    ) -> Result<(), Failure> {
        let history = history::of(self.start, &self.steps, contact_distance);
        self.page = self.page.map(|page| page.with_history(history));
        self.finish(verdict, scene)
    }
}
