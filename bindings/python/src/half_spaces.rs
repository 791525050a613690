//! Half spaces that no vertex may enter.

use exact_ccd_mesh::{HalfSpace, Separation};
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::error::refused;
use crate::positions::points;

/// Half spaces, each with a point of its boundary and the outward normal.
#[pyclass(frozen, module = "exact_ccd._native")]
pub(crate) struct HalfSpaces(Vec<HalfSpace>);

#[pymethods]
impl HalfSpaces {
    /// A row has the point, then the normal.
    #[new]
    fn new(rows: PyReadonlyArray2<'_, f64>) -> PyResult<Self> {
        let rows: &[[f64; 6]] = rows.as_slice()?.as_chunks().0;
        let half_space = |(number, &[x, y, z, nx, ny, nz]): (usize, &[f64; 6])| {
            let half_space = HalfSpace::new([x, y, z], [nx, ny, nz]);
            half_space
                .check()
                .map_err(|error| refused(format_args!("half space {number}: {error}")))?;
            Ok(half_space)
        };
        Ok(Self(
            rows.iter().enumerate().map(half_space).collect::<PyResult<_>>()?,
        ))
    }

    /// The first half space with a vertex that comes within its own distance, and the first such vertex; one
    /// distance may stand for all vertices. Decided exactly.
    fn touching(
        &self,
        py: Python<'_>,
        positions: PyReadonlyArray2<'_, f64>,
        distances: PyReadonlyArray1<'_, f64>,
    ) -> PyResult<Option<(usize, usize)>> {
        let positions = points(&positions)?;
        let distances = distances.as_slice()?.iter().map(|&d| Separation::new(d));
        let distances: Vec<Separation> = distances.collect::<Result<_, _>>().map_err(refused)?;
        Ok(py.detach(|| {
            self.0.iter().enumerate().find_map(|(number, half_space)| {
                let mut vertices = positions.iter().zip(distances.iter().cycle());
                let touches = |(&position, &d)| !half_space.is_apart(position, d);
                vertices.position(touches).map(|vertex| (number, vertex))
            })
        }))
    }
}
