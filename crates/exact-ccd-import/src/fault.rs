//! Errors of imports.

use std::fmt;
use std::path::{Path, PathBuf};

/// The entries of a scene of another program that cannot be imported: one on each line of the message.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", self.lines())]
pub struct ImportError {
    /// The file.
    pub file: PathBuf,
    /// The entries with their problems. Not empty.
    pub entries: Vec<(Place, Problem)>,
}

impl ImportError {
    fn lines(&self) -> String {
        let line =
            |(place, problem): &(Place, Problem)| format!("{}, {place}: {problem}", self.file.display());
        self.entries.iter().map(line).collect::<Vec<_>>().join("\n")
    }

    /// The error of a file with these faults.
    pub(super) fn new(file: &Path, faults: Vec<Fault>) -> Self {
        let entries = faults.into_iter().map(|fault| (fault.place, fault.problem));
        Self {
            file: file.to_owned(),
            entries: entries.collect(),
        }
    }
}

/// A place in a scene of another program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// A keyword in a text file.
    Line {
        /// The line, from 1.
        line: usize,
        /// The keyword.
        keyword: String,
    },
    /// A value of a JSON file, as a JSON pointer (RFC 6901). It is empty for the file as a whole.
    Pointer(String),
}

/// The reason why an entry cannot be imported.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// The keyword is none of the format.
    #[error("the keyword is unknown to {program}")]
    Unknown {
        /// The program of the format.
        program: &'static str,
    },
    /// A value is missing or out of range.
    #[error("found {found}, expected {expected}")]
    Invalid {
        /// The value, or `nothing`.
        found: String,
        /// The values that are allowed.
        expected: String,
    },
    /// Scenes of this program have no counterpart of the entry.
    #[error("exact-ccd has no counterpart of {what}: {instead}")]
    Unsupported {
        /// The meaning.
        what: String,
        /// An instruction.
        instead: String,
    },
    /// A file cannot be read.
    #[error("{0}")]
    File(String),
}

impl Place {
    /// True for a line with one of these keywords.
    pub(super) fn has_keyword(&self, keywords: &[&str]) -> bool {
        match self {
            Self::Line { keyword, .. } => keywords.contains(&keyword.as_str()),
            Self::Pointer(_) => false,
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line { line, keyword } => write!(f, "line {line}, `{keyword}`"),
            Self::Pointer(pointer) if pointer.is_empty() => write!(f, "the file"),
            Self::Pointer(pointer) => write!(f, "{pointer}"),
        }
    }
}

/// A problem at a place of the file that is being imported.
#[derive(Debug)]
pub(super) struct Fault {
    pub(super) place: Place,
    pub(super) problem: Problem,
}

impl Problem {
    pub(super) fn invalid(found: impl fmt::Display, expected: impl fmt::Display) -> Self {
        Self::Invalid {
            found: found.to_string(),
            expected: expected.to_string(),
        }
    }

    pub(super) fn unsupported(what: impl fmt::Display, instead: impl fmt::Display) -> Self {
        Self::Unsupported {
            what: what.to_string(),
            instead: instead.to_string(),
        }
    }

    pub(super) fn at(self, place: &Place) -> Fault {
        Fault {
            place: place.clone(),
            problem: self,
        }
    }
}
