//! The columns of a list of contacts.

use super::record::ContactRecord;
use crate::shortest::shortest;

/// A value in a column; an absent one is empty or null.
pub(super) enum Cell {
    Text(&'static str),
    Integer(Option<i64>),
    Real(Option<f64>),
}

/// The names of the columns.
pub(super) const COLUMNS: [&str; 21] = [
    "frame",
    "kind",
    "id_a",
    "id_b",
    "v0",
    "v1",
    "v2",
    "v3",
    "v4",
    "time_lower",
    "time_upper",
    "x",
    "y",
    "z",
    "nx",
    "ny",
    "nz",
    "u",
    "v",
    "distance_lower",
    "distance_upper",
];

/// A row: the values of a record in the order of the columns.
pub(super) fn row(record: &ContactRecord) -> [Cell; 21] {
    let ContactRecord {
        ids,
        vertices,
        time,
        point,
        normal,
        parameters,
        distance,
        ..
    } = record;
    let integer = |value: Option<u32>| Cell::Integer(value.map(i64::from));
    let real = |value: f64| Cell::Real(Some(value));
    let vertex = |index: usize| {
        let [first, second] = vertices;
        let vertex = first
            .get(index)
            .or_else(|| second.get(index.checked_sub(first.len())?));
        Cell::Integer(vertex.copied().map(i64::from))
    };
    let place = |axis: usize| Cell::Real(point.map(|point| point[axis]));
    let direction = |axis: usize| Cell::Real(normal.map(|normal| normal[axis]));
    let parameter = |index: usize| Cell::Real(parameters.map(|parameters| parameters[index]));
    [
        Cell::Integer(Some(record.frame as i64)),
        Cell::Text(record.kind.name()),
        integer(ids[0]),
        integer(ids[1]),
        vertex(0),
        vertex(1),
        vertex(2),
        vertex(3),
        vertex(4),
        real(time.lower),
        real(time.upper),
        place(0),
        place(1),
        place(2),
        direction(0),
        direction(1),
        direction(2),
        parameter(0),
        parameter(1),
        real(distance.lower),
        real(distance.upper),
    ]
}

/// The value in a CSV file.
impl std::fmt::Display for Cell {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Text(text) => f.write_str(text),
            Self::Integer(Some(value)) => write!(f, "{value}"),
            Self::Real(Some(value)) => f.write_str(&shortest(*value)),
            Self::Integer(None) | Self::Real(None) => Ok(()),
        }
    }
}
