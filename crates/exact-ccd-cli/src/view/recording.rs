//! The page of a motion whose frames come one after the other.

use std::path::PathBuf;

use exact_ccd_mesh::{Aabb, Frame, Point, Violation};
use exact_ccd_view::Page;

use crate::failure::Failure;

/// A motion that is recorded for its page.
pub(crate) struct Recording {
    file: PathBuf,
    title: String,
    up: Point,
    page: Option<Page>,
}

impl Recording {
    pub(super) fn new(file: PathBuf, title: String) -> Self {
        let (up, page) = ([0.0, 0.0, 1.0], None);
        Self { file, title, up, page }
    }

    /// The same recording with another direction upwards.
    pub(crate) fn with_up(self, up: Point) -> Self {
        Self { up, ..self }
    }

    /// Adds the next frame.
    pub(crate) fn add(&mut self, label: String, frame: &Frame) -> Result<(), Failure> {
        let page = self.page.get_or_insert_with(|| {
            let bounds: Aabb = frame.positions.iter().copied().collect();
            Page::new(&self.title, frame.mesh.clone(), &bounds).with_up(self.up)
        });
        Ok(page.add_frame(label, &frame.positions)?)
    }

    /// Adds a violation in the last frame, or in the step that leads to it.
    pub(crate) fn violation(&mut self, violation: &Violation) -> Result<(), Failure> {
        let Some(page) = &mut self.page else { return Ok(()) };
        Ok(match violation {
            Violation::Intersection { intersection, .. } => page.add_intersection(*intersection)?,
            Violation::Contact { contact, .. } => page.add_contact(contact)?,
        })
    }

    /// Writes the page, with the answer that was printed.
    pub(crate) fn finish(self, answer: &str) -> Result<(), Failure> {
        match self.page {
            Some(page) => super::write(&self.file, &page.with_summary(super::lines(answer))),
            None => Ok(()),
        }
    }
}
