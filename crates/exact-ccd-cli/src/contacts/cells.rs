//! The columns of a list of contacts.

use super::record::ContactRecord;
use crate::text::numbers::shortest;

/// A value in a column; an absent one is empty or null.
pub(super) enum Cell<'a> {
    Text(Option<&'a str>),
    Integer(Option<i64>),
    Real(Option<f64>),
}

/// A row: the values of a record by the names of the columns, in their order.
pub(super) fn row(record: &ContactRecord) -> [(&'static str, Cell<'_>); 25] {
    let integer = |value: Option<u32>| Cell::Integer(value.map(i64::from));
    let real = |value: f64| Cell::Real(Some(value));
    let vertex = |index: usize| integer(record.vertices.iter().flatten().nth(index).copied());
    let of = |numbers: Option<&[f64]>, index: usize| Cell::Real(numbers.map(|numbers| numbers[index]));
    let place = |axis: usize| of(record.point.as_ref().map(|point| &point[..]), axis);
    let direction = |axis: usize| of(record.normal.as_ref().map(|normal| &normal[..]), axis);
    let parameter = |index: usize| of(record.parameters.as_ref().map(|both| &both[..]), index);
    let owners = record.owners.as_ref();
    let part = |side: usize| Cell::Text(owners.and_then(|owners| owners.parts[side].as_deref()));
    let part_id = |side: usize| integer(owners.and_then(|owners| owners.part_ids[side]));
    [
        ("frame", Cell::Integer(Some(record.frame as i64))),
        ("kind", Cell::Text(Some(record.kind.name()))),
        ("id_a", integer(record.ids[0])),
        ("id_b", integer(record.ids[1])),
        ("v0", vertex(0)),
        ("v1", vertex(1)),
        ("v2", vertex(2)),
        ("v3", vertex(3)),
        ("v4", vertex(4)),
        ("time_lower", real(record.time.lower)),
        ("time_upper", real(record.time.upper)),
        ("x", place(0)),
        ("y", place(1)),
        ("z", place(2)),
        ("nx", direction(0)),
        ("ny", direction(1)),
        ("nz", direction(2)),
        ("u", parameter(0)),
        ("v", parameter(1)),
        ("distance_lower", real(record.distance.lower)),
        ("distance_upper", real(record.distance.upper)),
        ("part_a", part(0)),
        ("part_id_a", part_id(0)),
        ("part_b", part(1)),
        ("part_id_b", part_id(1)),
    ]
}

/// The value in a CSV file.
impl std::fmt::Display for Cell<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Text(Some(text)) if text.contains([',', '"', '\n', '\r']) => {
                write!(f, "\"{}\"", text.replace('"', "\"\""))
            }
            Self::Text(Some(text)) => f.write_str(text),
            Self::Integer(Some(value)) => write!(f, "{value}"),
            Self::Real(Some(value)) => f.write_str(&shortest(*value)),
            Self::Text(None) | Self::Integer(None) | Self::Real(None) => Ok(()),
        }
    }
}
