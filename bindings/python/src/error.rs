//! Errors in arguments.

use exact_ccd_certify::{MakerError, Uncertified};
use exact_ccd_mesh::{LineSearchError, StepError};
use pyo3::create_exception;
use pyo3::exceptions::{PyMemoryError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;

create_exception!(
    exact_ccd,
    CrossingError,
    PyValueError,
    "An edge passes through a face where a step begins: ``edge`` and ``face`` are their indices."
);

create_exception!(
    exact_ccd,
    UncertifiedError,
    PyRuntimeError,
    "Some pairs have no proof, so there is no certificate: ``missing`` of ``pairs``, and the name of the ``first``."
);

/// The `ValueError` with the message of an error.
pub(crate) fn refused(error: impl ToString) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// A vector with room for this many elements.
pub(crate) fn room<T>(count: usize) -> PyResult<Vec<T>> {
    let mut elements = Vec::new();
    let reserved = elements.try_reserve_exact(count);
    reserved.map_err(|_| PyMemoryError::new_err(format!("no memory for {count} results")))?;
    Ok(elements)
}

/// An error of one world.
pub(crate) struct Refusal {
    message: String,
    reason: Reason,
}

/// The fields of an exception.
enum Reason {
    Argument,
    /// The edge and the face.
    Crossing([u32; 2]),
    Uncertified(Uncertified),
}

impl Refusal {
    pub(crate) fn new(error: impl ToString) -> Self {
        let (message, reason) = (error.to_string(), Reason::Argument);
        Self { message, reason }
    }

    /// The exception, which names the world if there are several.
    pub(crate) fn into_exception(self, py: Python<'_>, world: Option<usize>) -> PyErr {
        let place = world.map_or_else(String::new, |world| format!("world {world}: "));
        let message = place + &self.message;
        let (exception, set): (PyErr, PyResult<()>) = match self.reason {
            Reason::Argument => (refused(message), Ok(())),
            Reason::Crossing([edge, face]) => {
                let exception = CrossingError::new_err(message);
                let value = exception.value(py);
                let set = value.setattr("edge", edge);
                let set = set.and_then(|()| value.setattr("face", face));
                (exception, set)
            }
            Reason::Uncertified(Uncertified {
                missing,
                pairs,
                first,
            }) => {
                let exception = UncertifiedError::new_err(message);
                let value = exception.value(py);
                let set = value.setattr("missing", missing);
                let set = set.and_then(|()| value.setattr("pairs", pairs));
                let set = set.and_then(|()| value.setattr("first", first));
                (exception, set)
            }
        };
        set.map_or_else(|failure| failure, |()| exception)
    }
}

impl From<StepError> for Refusal {
    fn from(error: StepError) -> Self {
        let reason = match error {
            StepError::Crossing { edge, face, .. } => Reason::Crossing([edge, face]),
            _ => Reason::Argument,
        };
        let message = error.to_string();
        Self { message, reason }
    }
}

impl From<LineSearchError> for Refusal {
    fn from(error: LineSearchError) -> Self {
        match error {
            LineSearchError::Step(error) => error.into(),
            error => Self::new(error),
        }
    }
}

impl From<MakerError> for Refusal {
    fn from(error: MakerError) -> Self {
        match error {
            MakerError::Step(error) => error.into(),
            error => Self::new(error),
        }
    }
}

impl From<Uncertified> for Refusal {
    fn from(error: Uncertified) -> Self {
        let (message, reason) = (error.to_string(), Reason::Uncertified(error));
        Self { message, reason }
    }
}
