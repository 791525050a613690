//! The broad phase for primitives in arrays.

use std::ops::ControlFlow;
use std::sync::Arc;

use exact_ccd::{Point, Separation};
use exact_ccd_mesh::{Aabb, BoxPairs, Boxes, PairCollector, check_positions};
use numpy::{PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::broad_phase::Interruptible;
use crate::compute::{Watch, compute};
use crate::error::refused;
use crate::mesh::{Table, rows};
use crate::positions::points;

/// Pairs of primitives, one of each array, without a common vertex, whose boxes over the step meet, each
/// enlarged by `inflation` on every side. Each row of an array has the vertices of a primitive.
#[pyfunction]
pub(crate) fn overlaps<'py>(
    py: Python<'py>,
    first: PyReadonlyArray2<'py, u32>,
    second: PyReadonlyArray2<'py, u32>,
    x0: PyReadonlyArray2<'py, f64>,
    x1: PyReadonlyArray2<'py, f64>,
    inflation: f64,
    threads: Option<usize>,
) -> PyResult<Table<'py, u32>> {
    let (x0, x1) = (points(&x0)?, points(&x1)?);
    let (a, b) = (Primitives::new(&first)?, Primitives::new(&second)?);
    let watch = Arc::<Watch>::default();
    let broad_phase = Interruptible { watch: watch.clone() };
    let pairs = compute(py, threads, None, &watch, || {
        let inflation = Separation::new(inflation).map_err(refused)?.get();
        check_positions(x0.len(), x0).map_err(refused)?;
        check_positions(x0.len(), x1).map_err(refused)?;
        a.check(x0.len())?;
        b.check(x0.len())?;
        let origin = a.place(x0);
        let boxes = |primitives: &Primitives<'_>| {
            let around = primitives.boxes(x0, x1, inflation);
            Boxes::relative_to(&around, &[origin]).map_err(refused)
        };
        let collector = PairCollector::default();
        let apart = |pair: &[u32; 2]| {
            let corners = b.vertices(pair[1]);
            a.vertices(pair[0]).iter().all(|vertex| !corners.contains(vertex))
        };
        let _: ControlFlow<()> = broad_phase.between(&boxes(&a)?, &boxes(&b)?, &|pairs| {
            collector.add(pairs.iter().copied().filter(apart))
        });
        Ok::<_, PyErr>(collector.into_sorted())
    })??;
    rows(py, pairs)
}

/// Primitives with equal numbers of vertices.
struct Primitives<'a> {
    vertices: &'a [u32],
    size: usize,
}

impl<'a> Primitives<'a> {
    fn new(array: &'a PyReadonlyArray2<'_, u32>) -> PyResult<Self> {
        let (vertices, size) = (array.as_slice()?, array.shape()[1].max(1));
        Ok(Self { vertices, size })
    }

    /// Checks that all vertices exist.
    fn check(&self, vertex_count: usize) -> PyResult<()> {
        let missing = |&vertex: &u32| vertex as usize >= vertex_count;
        match self.vertices.iter().position(missing) {
            None => Ok(()),
            Some(index) => Err(refused(format_args!(
                "row {}: vertex {}, but there are only {vertex_count} vertices",
                index / self.size,
                self.vertices[index]
            ))),
        }
    }

    fn vertices(&self, index: u32) -> &'a [u32] {
        &self.vertices[self.size * index as usize..][..self.size]
    }

    /// The place of a vertex in the middle of the array.
    fn place(&self, x: &[Point]) -> Point {
        let vertex = self.vertices.get(self.vertices.len() / 2);
        vertex.map_or([0.0; 3], |&vertex| x[vertex as usize])
    }

    /// The boxes around the paths, enlarged on every side.
    fn boxes(&self, x0: &[Point], x1: &[Point], inflation: f64) -> Vec<[Aabb; 1]> {
        let around = |vertices: &[u32]| {
            let ends = vertices.iter().flat_map(|&v| [x0[v as usize], x1[v as usize]]);
            [ends.collect::<Aabb>().inflated(inflation)]
        };
        self.vertices.par_chunks(self.size).map(around).collect()
    }
}
