//! Contacts as columns.

use exact_ccd::{EdgeEdge, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_mesh::{Contact, Pair, PairKind, Step};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;

use crate::impact::{COLUMNS, columns};
use crate::kind::ArrayKind;
use crate::mesh::rows;

/// The kind, the indices of both primitives and the vertices of each contact, its impact, and the
/// bounds of its distance. A pair of fewer than four vertices has −1 for the others.
pub(crate) type Columns<'py> = (
    Bound<'py, PyArray1<u8>>,
    Bound<'py, PyArray2<u32>>,
    Bound<'py, PyArray2<i64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
);

/// The columns before they belong to the interpreter.
#[derive(Default)]
pub(crate) struct Table {
    kinds: Vec<u8>,
    ids: Vec<[u32; 2]>,
    vertices: Vec<[i64; 4]>,
    impacts: Vec<[f64; COLUMNS]>,
    distances: Vec<[f64; 2]>,
}

impl Table {
    /// The columns of contacts of a step.
    pub(crate) fn new(step: &Step<'_>, contacts: &[Contact]) -> Self {
        let mut table = Self::default();
        for contact in contacts {
            match contact.pair {
                Pair::VertexFace { .. } => table.add::<VertexFace>(step, contact),
                Pair::EdgeEdge { .. } => table.add::<EdgeEdge>(step, contact),
                Pair::VertexEdge { .. } => table.add::<VertexEdge>(step, contact),
                Pair::VertexVertex { .. } => table.add::<VertexVertex>(step, contact),
            }
        }
        table
    }

    fn add<K: ArrayKind + PairKind>(&mut self, step: &Step<'_>, contact: &Contact) {
        let ids = contact.pair.ids();
        let vertices = <K as PairKind>::vertices(step.mesh(), ids).unwrap_or_default();
        let vertex = |index| vertices.as_ref().get(index).copied().map_or(-1, i64::from);
        // A contact of the step is a pair of its mesh.
        let query = step.query::<K>(ids);
        let impact = query.map_or([f64::NAN; COLUMNS], |query| columns(&query, &contact.impact));
        self.kinds.push(K::NUMBER);
        self.ids.push(ids);
        self.vertices.push([0, 1, 2, 3].map(vertex));
        self.impacts.push(impact);
        self.distances
            .push([contact.distance.lower, contact.distance.upper]);
    }

    /// The columns as arrays.
    pub(crate) fn into_arrays(self, py: Python<'_>) -> PyResult<Columns<'_>> {
        let kinds = PyArray1::from_vec(py, self.kinds);
        let (ids, vertices) = (rows(py, &self.ids)?, rows(py, &self.vertices)?);
        Ok((
            kinds,
            ids,
            vertices,
            rows(py, &self.impacts)?,
            rows(py, &self.distances)?,
        ))
    }
}
