//! Errors of the program.

use std::error::Error;
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

/// The message of another error. The limit on the size of a file is an option of the program, and an error of
/// input or output without a file comes from standard output.
impl<E: Error + 'static> From<E> for Failure {
    fn from(error: E) -> Self {
        let any: &dyn Error = &error;
        if let Some(source) = any.downcast_ref::<io::Error>() {
            return Self {
                is_closed_pipe: source.kind() == io::ErrorKind::BrokenPipe,
                ..Self::new(format_args!("cannot write the answer: {source}"))
            };
        }
        if let Some(ReadError::Parse { path, source }) = any.downcast_ref()
            && let Fault::Size { limit } = source.fault
        {
            let reason = format_args!("more than {limit} bytes, the size that --max-size allows");
            return Self::of(path, reason);
        }
        Self::new(error)
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
        Self {
            is_closed_pipe: source.kind() == io::ErrorKind::BrokenPipe,
            ..Self::new(format_args!("cannot write {}: {source}{remedy}", file.display()))
        }
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

/// The first names, at most this number, as a list.
pub(crate) fn listed(names: impl Iterator<Item = String>, most: usize) -> String {
    let mut names = names.fuse();
    let first: Vec<_> = names.by_ref().take(most).collect();
    let more = if names.next().is_some() {
        ", and others"
    } else {
        ""
    };
    first.join(", ") + more
}
