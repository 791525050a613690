//! Errors of the program.

use std::fmt::Display;
use std::io;
use std::path::Path;

use exact_ccd_files::{Fault, ReadError};

/// The reason why the program has no answer: a message for the user.
#[derive(Debug)]
pub(crate) struct Failure {
    message: String,
    is_closed_pipe: bool,
}

/// Failures with the messages of other errors.
macro_rules! failures {
    ($($error:ty),* $(,)?) => {
        $(impl From<$error> for $crate::failure::Failure {
            fn from(error: $error) -> Self {
                Self::new(error)
            }
        })*
    };
}
#[cfg(feature = "queries")]
pub(crate) use failures;

failures! {
    exact_ccd_files::ReadMotionError,
    exact_ccd_mesh::CandidateError,
    exact_ccd_mesh::StepError,
    exact_ccd_mesh::ThicknessCount,
    exact_ccd_view::PageError,
}

/// The limit on the size of a file is an option of the program.
impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        match &error {
            ReadError::Parse { path, source } => match source.fault {
                Fault::Size { limit } => Self::of(
                    path,
                    format_args!("more than {limit} bytes, the size that --max-size allows"),
                ),
                _ => Self::new(error),
            },
            _ => Self::new(error),
        }
    }
}

/// An error of standard output.
impl From<io::Error> for Failure {
    fn from(source: io::Error) -> Self {
        Self {
            is_closed_pipe: source.kind() == io::ErrorKind::BrokenPipe,
            ..Self::new(format_args!("cannot write the answer: {source}"))
        }
    }
}

impl Failure {
    pub(crate) fn new(message: impl Display) -> Self {
        Self {
            message: message.to_string(),
            is_closed_pipe: false,
        }
    }

    /// The failure of a file, or of a folder, with the reason.
    pub(crate) fn of(file: &Path, reason: impl Display) -> Self {
        Self::new(format_args!("{}: {reason}", file.display()))
    }

    /// The failure to write a file, with the remedy.
    pub(crate) fn write(file: &Path, source: io::Error) -> Self {
        let remedy = remedy(source.kind());
        Self::new(format_args!("cannot write {}: {source}{remedy}", file.display()))
    }

    /// The message on one line. Control characters, which names of files may have, become spaces.
    pub(crate) fn on_one_line(&self) -> String {
        self.message.replace(char::is_control, " ")
    }

    /// A closed pipe, as in `exact-ccd queries FILE | head`, is not a failure.
    pub(crate) fn unless_closed_pipe(self) -> Result<(), Self> {
        if self.is_closed_pipe { Ok(()) } else { Err(self) }
    }
}

/// The end of a message about a file that cannot be written: an instruction.
fn remedy(error: io::ErrorKind) -> &'static str {
    match error {
        io::ErrorKind::NotFound => "; make its folder first",
        io::ErrorKind::IsADirectory => "; name a file, as there is a folder of this name",
        io::ErrorKind::AlreadyExists | io::ErrorKind::NotADirectory => {
            "; name another folder, as there is a file of this name"
        }
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            "; name a folder in which files may be written"
        }
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "; the disk is full",
        _ => "",
    }
}

/// The number of names that a message lists.
const LISTED: usize = 20;

/// The first names, as a list.
pub(crate) fn listed(names: &[String]) -> String {
    let more = if names.len() > LISTED { ", and others" } else { "" };
    names[..names.len().min(LISTED)].join(", ") + more
}
