//! Errors in arguments.

use exact_ccd_mesh::{LineSearchError, StepError};
use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
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

/// The exception for a step: a [`CrossingError`] if its start is one.
pub(crate) fn refused_step(error: StepError) -> PyErr {
    let StepError::Crossing { edge, face, .. } = error else {
        return refused(error);
    };
    Python::attach(|py| {
        let exception = CrossingError::new_err(error.to_string());
        let value = exception.value(py);
        let fields = value
            .setattr("edge", edge)
            .and_then(|()| value.setattr("face", face));
        fields.map_or_else(|failure| failure, |()| exception)
    })
}

/// The exception for a certified step.
pub(crate) fn refused_search(error: LineSearchError) -> PyErr {
    match error {
        LineSearchError::Step(error) => refused_step(error),
        error => refused(error),
    }
}
