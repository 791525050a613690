//! Meshes, and the pairs that can collide.

use std::sync::{Arc, Mutex, PoisonError};

use exact_ccd_mesh::{CanCollide, GroupMatrix, TriangleMesh};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::{PyTraverseError, PyVisit};

use crate::compute::Watch;
use crate::error::refused;

/// A triangle mesh, with the rules for pairs that can collide.
#[pyclass(frozen, module = "exact_ccd._native")]
pub(crate) struct Mesh {
    mesh: Arc<TriangleMesh>,
    /// The pairs that can collide by their groups.
    by_groups: CanCollide,
    /// A function of two vertices.
    rule: Option<Py<PyAny>>,
}

impl Mesh {
    pub(crate) fn mesh(&self) -> &Arc<TriangleMesh> {
        &self.mesh
    }

    /// The rule of the caller, as a reference of its own for another object.
    pub(crate) fn shared_rule(&self, py: Python<'_>) -> Option<Arc<Py<PyAny>>> {
        self.rule.as_ref().map(|rule| Arc::new(rule.clone_ref(py)))
    }

    /// The pairs that can collide by their groups, whatever the rule.
    pub(crate) fn by_groups(&self) -> CanCollide {
        self.by_groups.clone()
    }

    /// The pairs of which two vertices can collide by their groups and by a rule.
    ///
    /// An exception of the rule is kept in `failure`, and ends the computation.
    pub(crate) fn ruled(
        &self,
        rule: Option<Arc<Py<PyAny>>>,
        watch: &Arc<Watch>,
        failure: &Arc<Mutex<Option<PyErr>>>,
    ) -> CanCollide {
        let Some(rule) = rule else {
            return self.by_groups();
        };
        let (watch, failure, by_groups) = (watch.clone(), failure.clone(), self.by_groups());
        CanCollide::any_vertices(move |v, w| {
            if watch.is_cancelled() || !by_groups.allows(&[v], &[w]) {
                return false;
            }
            let answer = Python::attach(|py| rule.bind(py).call1((v, w))?.is_truthy());
            answer.unwrap_or_else(|error| {
                let mut first = failure.lock().unwrap_or_else(PoisonError::into_inner);
                first.get_or_insert(error);
                watch.cancel();
                false
            })
        })
    }
}

#[pymethods]
impl Mesh {
    /// The rule is a function of two vertices, or a matrix of groups.
    #[new]
    fn new(
        py: Python<'_>,
        vertex_count: usize,
        faces: PyReadonlyArray2<'_, u32>,
        edges: PyReadonlyArray2<'_, u32>,
        groups: Option<PyReadonlyArray1<'_, u32>>,
        matrix: Option<PyReadonlyArray2<'_, bool>>,
        rule: Option<Py<PyAny>>,
    ) -> PyResult<Self> {
        let (faces, edges) = (faces.as_slice()?.as_chunks().0, edges.as_slice()?.as_chunks().0);
        let mesh = py
            .detach(|| TriangleMesh::with_edges(vertex_count, faces.to_vec(), edges))
            .map_err(refused)?;
        Ok(Self {
            mesh: Arc::new(mesh),
            by_groups: by_groups(groups, matrix)?,
            rule,
        })
    }

    /// The rule may refer to an object that has the mesh. It is there before the mesh is, so another object
    /// of such a cycle can be changed: only that one needs a way to break it.
    fn __traverse__(&self, visit: PyVisit<'_>) -> Result<(), PyTraverseError> {
        visit.call(&self.rule)
    }

    /// The number of vertices.
    #[getter]
    fn vertex_count(&self) -> usize {
        self.mesh.vertex_count()
    }

    /// The faces.
    #[getter]
    fn faces<'py>(&self, py: Python<'py>) -> PyResult<Table<'py, u32>> {
        rows(py, self.mesh.faces().iter().copied())
    }

    /// The edges of the faces, then the loose edges.
    #[getter]
    fn edges<'py>(&self, py: Python<'py>) -> PyResult<Table<'py, u32>> {
        rows(py, self.mesh.edges().iter().copied())
    }

    /// The number of loose edges.
    #[getter]
    fn loose_edge_count(&self) -> usize {
        self.mesh.loose_edges().len()
    }
}

/// The pairs that can collide by the groups of vertices: those of different groups, or those in a matrix.
fn by_groups(
    groups: Option<PyReadonlyArray1<'_, u32>>,
    matrix: Option<PyReadonlyArray2<'_, bool>>,
) -> PyResult<CanCollide> {
    let Some(groups) = groups else {
        return Ok(CanCollide::all());
    };
    let groups = groups.as_slice()?.to_vec();
    let Some(matrix) = matrix else {
        return Ok(CanCollide::different_groups(groups));
    };
    GroupMatrix::new(matrix.shape()[0], matrix.as_slice()?.to_vec())
        .and_then(|matrix| CanCollide::by_groups(groups, matrix))
        .map_err(|error| refused(format_args!("can_collide: {error}")))
}

/// An array of one dimension.
pub(crate) type List<'py, T> = Bound<'py, PyArray1<T>>;

/// An array of two dimensions.
pub(crate) type Table<'py, T> = Bound<'py, PyArray2<T>>;

/// An array of rows.
pub(crate) fn rows<T: numpy::Element + Copy, const N: usize>(
    py: Python<'_>,
    rows: impl IntoIterator<Item = [T; N]>,
) -> PyResult<Table<'_, T>> {
    let rows: Vec<[T; N]> = rows.into_iter().collect();
    let shape = [rows.len(), N];
    PyArray1::from_vec(py, rows.into_flattened()).reshape(shape)
}
