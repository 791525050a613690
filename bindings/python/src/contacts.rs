//! Contacts as columns.

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_mesh::{Contact, Pair, Step};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;

use crate::impact::{COLUMNS, columns};
use crate::mesh::rows;

/// The kind, the indices of both primitives and the vertices of each contact, and its impact. The numbers of
/// kinds are their places in "vf", "ee". A pair of fewer than four vertices has −1 for the others.
pub(crate) type Columns<'py> = (
    Bound<'py, PyArray1<u8>>,
    Bound<'py, PyArray2<u32>>,
    Bound<'py, PyArray2<i64>>,
    Bound<'py, PyArray2<f64>>,
);

/// The columns of contacts of a step.
pub(crate) fn table<'py>(py: Python<'py>, step: &Step<'_>, contacts: &[Contact]) -> PyResult<Columns<'py>> {
    let kinds = contacts.iter().map(|contact| match contact.pair {
        Pair::VertexFace { .. } => 0,
        Pair::EdgeEdge { .. } => 1,
    });
    let ids: Vec<[u32; 2]> = contacts.iter().map(|contact| ids(contact.pair)).collect();
    let vertices: Vec<[i64; 4]> = contacts
        .iter()
        .map(|contact| vertices(step, contact.pair))
        .collect();
    let impacts: Vec<[f64; COLUMNS]> = contacts.iter().map(|contact| impact(step, contact)).collect();
    let kinds = PyArray1::from_iter(py, kinds);
    Ok((kinds, rows(py, &ids)?, rows(py, &vertices)?, rows(py, &impacts)?))
}

fn ids(pair: Pair) -> [u32; 2] {
    match pair {
        Pair::VertexFace { vertex, face } => [vertex, face],
        Pair::EdgeEdge { a, b } => [a, b],
    }
}

fn vertices(step: &Step<'_>, pair: Pair) -> [i64; 4] {
    pair.vertices(step.mesh())
        .map_or([-1; 4], |vertices| vertices.map(i64::from))
}

fn impact(step: &Step<'_>, contact: &Contact) -> [f64; COLUMNS] {
    let impact = &contact.impact;
    let columns = match contact.pair {
        Pair::VertexFace { vertex, face } => step
            .query::<VertexFace>([vertex, face])
            .map(|query| columns(&query, impact)),
        Pair::EdgeEdge { a, b } => step
            .query::<EdgeEdge>([a, b])
            .map(|query| columns(&query, impact)),
    };
    // A contact of the step is a pair of its mesh.
    columns.unwrap_or([f64::NAN; COLUMNS])
}
