//! Contacts as columns.

use exact_ccd::Point;
use exact_ccd_mesh::{Contact, Pair, TriangleMesh};
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::impact::{COLUMNS, columns};
use crate::mesh::{List, Table, rows};
use crate::queries::offsets;

/// A pair of primitives in numbers.
pub(crate) struct PairRow {
    kind: u8,
    ids: [u32; 2],
    vertices: [i64; 4],
}

impl PairRow {
    /// A pair of a mesh.
    pub(crate) fn new(mesh: &TriangleMesh, pair: Pair) -> Self {
        let vertices = pair.vertices(mesh).unwrap_or_default();
        let vertex = |index| vertices.get(index).copied().map_or(-1, i64::from);
        Self {
            kind: pair.kind() as u8,
            ids: pair.ids(),
            vertices: [0, 1, 2, 3].map(vertex),
        }
    }
}

/// A contact in numbers.
pub(crate) struct Row {
    pair: PairRow,
    impact: [f64; COLUMNS],
    distance: [f64; 2],
}

impl Row {
    /// A contact of a mesh with these positions at both ends of the step.
    pub(crate) fn new(mesh: &TriangleMesh, ends: [&[Point]; 2], contact: &Contact) -> Self {
        let pair = contact.pair;
        // A contact of the step is a pair of its mesh.
        let vertices = pair.vertices(mesh).unwrap_or_default();
        let (first, second) = vertices.split_at(pair.kind().sizes()[0].min(vertices.len()));
        Self {
            pair: PairRow::new(mesh, pair),
            impact: columns(&contact.impact, [first, second], ends),
            distance: [contact.distance.lower, contact.distance.upper],
        }
    }
}

/// The kind of each pair, the indices of both primitives, and their vertices. A pair of fewer than four
/// vertices has −1 for the others.
pub(crate) type PairColumns<'py> = (List<'py, u8>, Table<'py, u32>, Table<'py, i64>);

/// Pairs as columns.
pub(crate) fn pair_columns<'py, 'a>(
    py: Python<'py>,
    pairs: impl Iterator<Item = &'a PairRow> + Clone,
) -> PyResult<PairColumns<'py>> {
    Ok((
        PyArray1::from_iter(py, pairs.clone().map(|pair| pair.kind)),
        rows(py, pairs.clone().map(|pair| pair.ids))?,
        rows(py, pairs.map(|pair| pair.vertices))?,
    ))
}

/// The index of the first contact of each world; the pairs of the contacts, their impacts, and the bounds of
/// their distances.
pub(crate) type Columns<'py> = (List<'py, i64>, PairColumns<'py>, Table<'py, f64>, Table<'py, f64>);

/// The contacts of worlds as columns.
pub(crate) fn into_columns<'py, C>(py: Python<'py>, worlds: &[C]) -> PyResult<Columns<'py>>
where
    for<'a> &'a C: IntoIterator<Item = &'a Row>,
{
    let every: Vec<&Row> = worlds.iter().flatten().collect();
    let each = every.iter();
    Ok((
        offsets(py, worlds.iter().map(|contacts| contacts.into_iter().count())),
        pair_columns(py, each.clone().map(|contact| &contact.pair))?,
        rows(py, each.clone().map(|contact| contact.impact))?,
        rows(py, each.map(|contact| contact.distance))?,
    ))
}
