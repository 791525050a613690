//! Errors in arguments.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// The `ValueError` with the message of an error.
pub(crate) fn refused(error: impl ToString) -> PyErr {
    PyValueError::new_err(error.to_string())
}
