//! Why the program has no answer.

use std::io;

use ccd_bench::DataError;
use ccd_mesh::{ReadMotionError, StepError};

/// Why the program has no answer.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    #[error(transparent)]
    Data(#[from] DataError),
    #[error(transparent)]
    Motion(#[from] ReadMotionError),
    #[error(transparent)]
    Step(#[from] StepError),
    #[error("cannot start the threads: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    #[error("cannot write the answer: {0}")]
    Output(#[from] io::Error),
}

impl Failure {
    /// The message, even if a file has a line break or another control character in its name.
    pub(crate) fn on_one_line(&self) -> String {
        self.to_string().replace(char::is_control, " ")
    }

    /// A reader who wants to read no more, as in `exact-ccd queries FILE | head`, is no failure.
    pub(crate) fn unless_closed_pipe(self) -> Result<(), Self> {
        match self {
            Self::Output(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            failure => Err(failure),
        }
    }
}
