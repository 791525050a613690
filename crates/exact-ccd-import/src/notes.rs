//! Notes on entries without effect, and the errors after which an import goes on.

use std::cell::RefCell;
use std::fmt;
use std::path::{Path, PathBuf};

use super::fault::{Fault, Place};

/// An entry of a file that is ignored.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// The file.
    pub file: PathBuf,
    /// The place of the entry.
    pub place: Place,
    /// The reason.
    pub message: String,
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}: {}", self.file.display(), self.place, self.message)
    }
}

/// The notes and errors of the file that is being imported, to which all of its readers add.
#[derive(Debug, Default)]
pub(super) struct Notes {
    notes: RefCell<Vec<(Place, String)>>,
    faults: RefCell<Vec<Fault>>,
}

impl Notes {
    pub(super) fn add(&self, place: Place, message: impl Into<String>) {
        self.notes.borrow_mut().push((place, message.into()));
    }

    /// Adds an error. The import goes on without the entry, to find all errors, and fails at the end.
    pub(super) fn fail(&self, fault: Fault) {
        self.faults.borrow_mut().push(fault);
    }

    /// The errors since the last call.
    pub(super) fn take_faults(&self) -> Vec<Fault> {
        self.faults.take()
    }

    pub(super) fn in_file(self, file: &Path) -> Vec<Note> {
        let note = |(place, message)| Note {
            file: file.to_owned(),
            place,
            message,
        };
        self.notes.into_inner().into_iter().map(note).collect()
    }
}
