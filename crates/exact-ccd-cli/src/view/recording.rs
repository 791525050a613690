//! The page of a motion whose frames come one after the other.

use std::path::{Path, PathBuf};

use exact_ccd_mesh::{Frame, Violation};
#[cfg(feature = "simulate")]
use exact_ccd_view::History;
use exact_ccd_view::Page;

use super::setup::Setup;
use crate::failure::Failure;

/// A motion that is recorded for its page, if there is to be one.
pub(crate) struct Recording {
    file: Option<PathBuf>,
    title: String,
    /// The contents of the page, until it begins.
    setup: Setup,
    page: Option<Page>,
}

impl Recording {
    /// The recording for a page in a file; `setup` is not called if there is to be none.
    pub(super) fn new(file: Option<PathBuf>, title: String, setup: impl FnOnce() -> Setup) -> Self {
        Self {
            setup: if file.is_some() { setup() } else { Setup::default() },
            file,
            title,
            page: None,
        }
    }

    /// The file of the page, if there is to be one.
    #[cfg(feature = "simulate")]
    pub(super) fn file(&self) -> Option<&Path> {
        self.file.as_deref()
    }

    /// The same recording with charts.
    #[cfg(feature = "simulate")]
    pub(super) fn with_history(self, history: History) -> Self {
        Self {
            page: self.page.map(|page| page.with_history(history)),
            ..self
        }
    }

    /// Adds the next frame, from a file.
    pub(crate) fn add(&mut self, name: &str, frame: &Frame) -> Result<(), Failure> {
        if self.file.is_none() {
            return Ok(());
        }
        self.push(&super::name(Path::new(name)), frame)
    }

    pub(super) fn push(&mut self, label: &str, frame: &Frame) -> Result<(), Failure> {
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
}
