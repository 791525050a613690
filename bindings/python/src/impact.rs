//! Impacts as rows of numbers.

use exact_ccd::{Impact, Kind, Point, Query};
use exact_ccd_mesh::contact_points;

/// The number of columns of an impact.
pub(crate) const COLUMNS: usize = 12;

/// Time, u, v, the normal, and the closest points on both primitives, which are given by their vertices. A
/// normal that does not exist is NaN.
pub(crate) fn columns(impact: &Impact, primitives: [&[u32]; 2], ends: [&[Point]; 2]) -> [f64; COLUMNS] {
    let [u, v] = impact.parameters;
    let [nx, ny, nz] = impact.normal.unwrap_or([f64::NAN; 3]);
    // All vertices have positions.
    let points = contact_points(primitives, ends, impact).unwrap_or([[f64::NAN; 3]; 2]);
    let [[px, py, pz], [qx, qy, qz]] = points;
    [impact.time.lower(), u, v, nx, ny, nz, px, py, pz, qx, qy, qz]
}

/// The columns of the impact of a query.
pub(crate) fn columns_of_query<K: Kind>(query: &Query<K>, impact: &Impact) -> [f64; COLUMNS] {
    let [start, end] = query.points();
    let [start, end] = [start.as_ref(), end.as_ref()];
    let (first, second) = [0, 1, 2, 3][..start.len()].split_at(K::FIRST);
    columns(impact, [first, second], [start, end])
}
