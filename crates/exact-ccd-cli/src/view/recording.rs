//! The page of a motion whose frames come one after the other.

#[cfg(feature = "simulate")]
use std::path::Path;
use std::path::PathBuf;

use exact_ccd_mesh::{Aabb, Contact, Intersection, Point, TriangleMesh};
#[cfg(feature = "simulate")]
use exact_ccd_view::History;
use exact_ccd_view::{Page, PageError};

use super::setup::Setup;
use crate::messages::failure::Failure;

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

    /// Begins the page, unless it has begun, for frames of a mesh in a box.
    pub(crate) fn begin(&mut self, mesh: &TriangleMesh, bounds: impl FnOnce() -> Aabb) {
        if self.file.is_some() && self.page.is_none() {
            let setup = std::mem::take(&mut self.setup);
            self.page = Some(setup.page(&self.title, mesh.clone(), &bounds()));
        }
    }

    /// Adds the next frame. All further methods do nothing if the page has not begun.
    pub(crate) fn add(&mut self, label: &str, positions: &[Point]) -> Result<(), Failure> {
        self.change(|page| page.add_frame(label, positions))
    }

    /// Adds an intersection in the last frame.
    pub(crate) fn intersection(&mut self, intersection: Intersection) -> Result<(), Failure> {
        self.change(|page| page.add_intersection(intersection))
    }

    /// Adds a contact in the step that leads to the last frame.
    pub(crate) fn contact(&mut self, contact: &Contact) -> Result<(), Failure> {
        self.change(|page| page.add_contact(contact))
    }

    /// Adds the contact of a vertex and the half space of this number: at a time in the step that leads to
    /// the last frame, or in that frame at rest.
    pub(crate) fn half_space_contact(
        &mut self,
        vertex: u32,
        half_space: u32,
        time: Option<f64>,
    ) -> Result<(), Failure> {
        self.change(|page| page.add_half_space_contact(vertex, half_space, time))
    }

    fn change(&mut self, change: impl FnOnce(&mut Page) -> Result<(), PageError>) -> Result<(), Failure> {
        self.page.as_mut().map_or(Ok(()), |page| Ok(change(page)?))
    }

    /// Writes the page with the printed answer. One of its lines is the verdict.
    pub(crate) fn finish(self, verdict: &str, answer: &str) -> Result<(), Failure> {
        match (self.file, self.page) {
            (Some(file), Some(page)) => super::write(&file, &super::with_answer(page, verdict, answer)),
            _ => Ok(()),
        }
    }
}
