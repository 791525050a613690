//! Mesh files.

use std::path::PathBuf;

use exact_ccd_files::ReadError;
use exact_ccd_mesh::Frame;
use numpy::PyArray2;
use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;

use crate::mesh::rows;

/// The vertices, faces and loose edges in a file.
#[pyfunction]
#[expect(clippy::type_complexity, reason = "a tuple for Python")]
pub(crate) fn read_mesh<'py>(
    py: Python<'py>,
    path: PathBuf,
) -> PyResult<(
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<u32>>,
    Bound<'py, PyArray2<u32>>,
)> {
    let Frame { mesh, positions } =
        py.detach(|| exact_ccd_files::read_frame(path))
            .map_err(|error| match error {
                ReadError::Io { .. } => PyOSError::new_err(error.to_string()),
                _ => PyValueError::new_err(error.to_string()),
            })?;
    Ok((
        rows(py, &positions)?,
        rows(py, mesh.faces())?,
        rows(py, mesh.loose_edges())?,
    ))
}
