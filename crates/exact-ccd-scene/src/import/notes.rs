//! Notes on entries without effect.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use super::fault::Place;

/// An entry of a file that is ignored.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}, {place}: {message}", file.display())]
pub struct Note {
    /// The file.
    pub file: PathBuf,
    /// The place of the entry.
    pub place: Place,
    /// The reason.
    pub message: String,
}

/// The notes on the file that is being imported, to which all of its readers add.
#[derive(Debug, Default)]
pub(super) struct Notes(RefCell<Vec<(Place, String)>>);

impl Notes {
    pub(super) fn add(&self, place: Place, message: impl Into<String>) {
        self.0.borrow_mut().push((place, message.into()));
    }

    pub(super) fn in_file(self, file: &Path) -> Vec<Note> {
        let note = |(place, message)| Note {
            file: file.to_owned(),
            place,
            message,
        };
        self.0.into_inner().into_iter().map(note).collect()
    }
}
