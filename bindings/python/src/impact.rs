//! Impacts as rows of numbers.

use exact_ccd::{Impact, Point, Query};

use crate::kind::ArrayKind;

/// The number of columns of an impact.
pub(crate) const COLUMNS: usize = 12;

/// Time, u, v, the normal, and the closest points on both primitives. A normal that does not exist is NaN.
pub(crate) fn columns<K: ArrayKind>(query: &Query<K>, impact: &Impact) -> [f64; COLUMNS] {
    let time = impact.time.lower();
    let [u, v] = impact.parameters;
    let [nx, ny, nz] = impact.normal.unwrap_or([f64::NAN; 3]);
    let [start, end] = query.points();
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| sum([(1.0 - time, start[i]), (time, end[i])]));
    let (first, second) = if K::IS_FACE {
        (a, sum([(1.0 - u - v, b), (u, c), (v, d)]))
    } else {
        (sum([(1.0 - u, a), (u, b)]), sum([(1.0 - v, c), (v, d)]))
    };
    let ([px, py, pz], [qx, qy, qz]) = (first, second);
    [time, u, v, nx, ny, nz, px, py, pz, qx, qy, qz]
}

/// The sum of points with weights that add up to 1: between the points, though rounding may lead beyond them,
/// and beyond the largest f64.
fn sum<const N: usize>(points: [(f64, Point); N]) -> Point {
    [0, 1, 2].map(|axis| {
        let values = points.map(|(_, point)| point[axis]);
        let sum: f64 = points.iter().map(|(weight, point)| weight * point[axis]).sum();
        sum.max(values.into_iter().fold(f64::INFINITY, f64::min))
            .min(values.into_iter().fold(f64::NEG_INFINITY, f64::max))
    })
}
