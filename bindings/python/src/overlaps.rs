//! The broad phase for primitives in arrays.

use std::ops::ControlFlow;
use std::sync::Arc;

use exact_ccd::Point;
use exact_ccd_mesh::{Aabb, Boxes, BroadPhase, PairCollector, check_positions};
use numpy::{PyArray2, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::broad_phase::Interruptible;
use crate::compute::{Watch, compute};
use crate::mesh::rows;

/// Pairs of primitives, one of each array, without a common vertex, whose boxes over the step come within a
/// distance of each other. Each row of an array has the vertices of a primitive.
#[pyfunction]
pub(crate) fn overlaps<'py>(
    py: Python<'py>,
    first: PyReadonlyArray2<'py, u32>,
    second: PyReadonlyArray2<'py, u32>,
    x0: PyReadonlyArray2<'py, f64>,
    x1: PyReadonlyArray2<'py, f64>,
    distance: f64,
    threads: Option<usize>,
) -> PyResult<Bound<'py, PyArray2<u32>>> {
    let refused = |error: &dyn ToString| PyValueError::new_err(error.to_string());
    let x0: &[Point] = x0.as_slice()?.as_chunks().0;
    let x1: &[Point] = x1.as_slice()?.as_chunks().0;
    check_positions(x0.len(), x0).map_err(|error| refused(&error))?;
    check_positions(x0.len(), x1).map_err(|error| refused(&error))?;
    let a = Primitives::new(&first, x0.len())?;
    let b = Primitives::new(&second, x0.len())?;
    let watch = Arc::<Watch>::default();
    let broad_phase = Interruptible { watch: watch.clone() };
    let pairs = compute(py, threads, None, &watch, || {
        let [first, second] = [&a, &b].map(|primitives| primitives.boxes(x0, x1, distance));
        let collector = PairCollector::default();
        let apart = |pair: &[u32; 2]| {
            let corners = b.vertices(pair[1]);
            a.vertices(pair[0]).iter().all(|vertex| !corners.contains(vertex))
        };
        let _: ControlFlow<()> = broad_phase.between(&first?, &second?, &|pairs| {
            collector.add(pairs.iter().copied().filter(apart))
        });
        Ok::<_, exact_ccd_mesh::TooManyPrimitives>(collector.into_sorted())
    })?;
    rows(py, &pairs.map_err(|error| refused(&error))?)
}

/// Primitives with equal numbers of vertices.
struct Primitives<'a> {
    vertices: &'a [u32],
    size: usize,
}

impl<'a> Primitives<'a> {
    fn new(array: &'a PyReadonlyArray2<'_, u32>, vertex_count: usize) -> PyResult<Self> {
        let (vertices, size) = (array.as_slice()?, array.shape()[1].max(1));
        let missing = vertices
            .iter()
            .position(|&vertex| vertex as usize >= vertex_count);
        match missing {
            None => Ok(Self { vertices, size }),
            Some(index) => Err(PyValueError::new_err(format!(
                "row {}: vertex {}, but there are only {vertex_count} vertices",
                index / size,
                vertices[index]
            ))),
        }
    }

    fn vertices(&self, index: u32) -> &'a [u32] {
        &self.vertices[self.size * index as usize..][..self.size]
    }

    /// The boxes around the paths, larger by the distance on every side: half of it would do.
    fn boxes(
        &self,
        x0: &[Point],
        x1: &[Point],
        distance: f64,
    ) -> Result<Boxes<1>, exact_ccd_mesh::TooManyPrimitives> {
        let around = |vertices: &[u32]| {
            let ends = vertices.iter().flat_map(|&v| [x0[v as usize], x1[v as usize]]);
            [ends.collect::<Aabb>().inflated(distance)]
        };
        let boxes: Vec<_> = self.vertices.par_chunks(self.size).map(around).collect();
        Boxes::new(&boxes)
    }
}
