//! Minimum distances as the caller has them.

use exact_ccd::{Separation, Thickness};
use exact_ccd_mesh::MinDistance;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;

use crate::error::refused;

/// A thickness for each vertex, or one distance for all pairs.
#[derive(FromPyObject)]
pub(crate) enum Distance<'py> {
    Thickness(PyReadonlyArray1<'py, f64>),
    Uniform(f64),
}

impl Distance<'_> {
    /// The distance, with an inner one for pairs that start within it.
    pub(crate) fn with_inner(&self, inner: Option<f64>) -> PyResult<MinDistance> {
        let outer = match self {
            Self::Thickness(values) => {
                MinDistance::thickness(Thickness::new(values.as_slice()?).map_err(refused)?)
            }
            Self::Uniform(d) => MinDistance::uniform(Separation::new(*d).map_err(refused)?),
        };
        let inner = inner.map(Separation::new).transpose().map_err(refused)?;
        Ok(match inner {
            Some(inner) => outer.with_inner(inner),
            None => outer,
        })
    }
}
