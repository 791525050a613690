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

/// The columns of contacts of a step.
pub(crate) fn table<'py>(py: Python<'py>, step: &Step<'_>, contacts: &[Contact]) -> PyResult<Columns<'py>> {
    let kinds = contacts.iter().map(|contact| kind(contact.pair).0);
    let ids: Vec<[u32; 2]> = contacts.iter().map(|contact| kind(contact.pair).1).collect();
    let vertices: Vec<[i64; 4]> = contacts
        .iter()
        .map(|contact| vertices(step, contact.pair))
        .collect();
    let impacts: Vec<[f64; COLUMNS]> = contacts.iter().map(|contact| impact(step, contact)).collect();
    let distances = contacts.iter().map(|contact| contact.distance);
    let distances: Vec<[f64; 2]> = distances.map(|bounds| [bounds.lower, bounds.upper]).collect();
    let kinds = PyArray1::from_iter(py, kinds);
    let (ids, vertices) = (rows(py, &ids)?, rows(py, &vertices)?);
    Ok((kinds, ids, vertices, rows(py, &impacts)?, rows(py, &distances)?))
}

/// The place of the kind in "vf", "ee", "ve", "vv", and the indices of the primitives.
fn kind(pair: Pair) -> (u8, [u32; 2]) {
    match pair {
        Pair::VertexFace { vertex, face } => (0, [vertex, face]),
        Pair::EdgeEdge { a, b } => (1, [a, b]),
        Pair::VertexEdge { vertex, edge } => (2, [vertex, edge]),
        Pair::VertexVertex { a, b } => (3, [a, b]),
    }
}

fn vertices(step: &Step<'_>, pair: Pair) -> [i64; 4] {
    let mut vertices = pair.vertices(step.mesh()).unwrap_or_default().into_iter();
    [(); 4].map(|()| vertices.next().map_or(-1, i64::from))
}

fn impact(step: &Step<'_>, contact: &Contact) -> [f64; COLUMNS] {
    fn of<K: ArrayKind + PairKind>(step: &Step<'_>, contact: &Contact, ids: [u32; 2]) -> [f64; COLUMNS] {
        let query = step.query::<K>(ids);
        // A contact of the step is a pair of its mesh.
        query.map_or([f64::NAN; COLUMNS], |query| columns(&query, &contact.impact))
    }
    match kind(contact.pair) {
        (0, ids) => of::<VertexFace>(step, contact, ids),
        (1, ids) => of::<EdgeEdge>(step, contact, ids),
        (2, ids) => of::<VertexEdge>(step, contact, ids),
        (_, ids) => of::<VertexVertex>(step, contact, ids),
    }
}
