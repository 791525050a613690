//! The page of a motion whose frames come one after the other.

use std::io;
use std::path::{Path, PathBuf};

use exact_ccd_files::FileIds;
use exact_ccd_mesh::{Aabb, Frame, Point, Violation};
use exact_ccd_sim::Simulation;
use exact_ccd_view::Page;

use crate::failure::Failure;

/// A motion that is recorded for its page, if there is to be one.
pub(crate) struct Recording {
    file: Option<PathBuf>,
    title: String,
    page: Option<Page>,
    /// The ids of vertices and faces in their files, if the frames are from files.
    ids: Option<FileIds>,
}

impl Recording {
    pub(super) fn new(file: Option<PathBuf>, title: String) -> Self {
        Self {
            file,
            title,
            page: None,
            ids: None,
        }
    }

    /// The same recording with the ids of vertices and faces in their files.
    pub(crate) fn with_ids(self, ids: &FileIds) -> Self {
        let ids = self.file.is_some().then(|| ids.clone());
        Self { ids, ..self }
    }

    /// Adds the next frame, from a file.
    pub(crate) fn add(&mut self, name: &str, frame: &Frame) -> Result<(), Failure> {
        if self.file.is_none() {
            return Ok(());
        }
        self.push(&super::name(Path::new(name)), frame, [0.0, 0.0, 1.0])
    }

    /// Adds the surface in the state of a simulation.
    pub(crate) fn add_state(&mut self, simulation: &Simulation) -> Result<(), Failure> {
        let Some(file) = &self.file else { return Ok(()) };
        let surface = simulation.system().surface_frame(&simulation.state().positions);
        let frame = surface.map_err(|error| Failure::write(file, io::Error::other(error)))?;
        let gravity = simulation.settings().gravity;
        let falls = gravity.iter().any(|&g| g != 0.0);
        let up = if falls {
            gravity.map(|g| -g)
        } else {
            [0.0, 1.0, 0.0]
        };
        // Without the rounding errors of multiples of the time step.
        let time = (1e9 * simulation.time()).round() / 1e9;
        self.push(&format!("{time} s"), &frame, up)
    }

    fn push(&mut self, label: &str, frame: &Frame, up: Point) -> Result<(), Failure> {
        let page = self.page.get_or_insert_with(|| {
            let bounds: Aabb = frame.positions.iter().copied().collect();
            let page = Page::new(&self.title, frame.mesh.clone(), &bounds).with_up(up);
            match self.ids.take() {
                Some(ids) => page.with_ids(ids.vertices, ids.faces),
                None => page,
            }
        });
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

    /// Writes the page, with the answer that was printed.
    pub(crate) fn finish(self, answer: &str) -> Result<(), Failure> {
        match (self.file, self.page) {
            (Some(file), Some(page)) => super::write(&file, &page.with_summary(super::lines(answer))),
            _ => Ok(()),
        }
    }
}
