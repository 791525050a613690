//! Errors in arguments.

use exact_ccd_mesh::{LineSearchError, StepError};
use pyo3::create_exception;
use pyo3::exceptions::{PyMemoryError, PyValueError};
use pyo3::prelude::*;

create_exception!(
    exact_ccd,
    CrossingError,
    PyValueError,
    "An edge passes through a face where a step begins: ``edge`` and ``face`` are their indices."
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

/// An error of one world, and the edge and the face of a crossing.
pub(crate) struct Refusal {
    message: String,
    crossing: Option<[u32; 2]>,
}

impl Refusal {
    pub(crate) fn new(error: impl ToString) -> Self {
        let message = error.to_string();
        Self {
            message,
            crossing: None,
        }
    }

    /// The exception, which names the world if there are several.
    pub(crate) fn into_exception(self, py: Python<'_>, world: Option<usize>) -> PyErr {
        let place = world.map_or_else(String::new, |world| format!("world {world}: "));
        let message = place + &self.message;
        let Some([edge, face]) = self.crossing else {
            return refused(message);
        };
        let exception = CrossingError::new_err(message);
        let value = exception.value(py);
        let fields = value
            .setattr("edge", edge)
            .and_then(|()| value.setattr("face", face));
        fields.map_or_else(|failure| failure, |()| exception)
    }
}

impl From<StepError> for Refusal {
    fn from(error: StepError) -> Self {
        let crossing = match error {
            StepError::Crossing { edge, face, .. } => Some([edge, face]),
            _ => None,
        };
        let message = error.to_string();
        Self { message, crossing }
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
