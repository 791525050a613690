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
    let mut now = query.points()[0];
    for (now, &end) in now.as_mut().iter_mut().zip(query.points()[1].as_ref()) {
        *now = sum(&[*now, end], &[1.0 - time, time]);
    }
    let (first, second) = now.as_ref().split_at(K::FIRST);
    let [px, py, pz] = sum(first, &[1.0 - u, u]);
    let [qx, qy, qz] = if K::IS_FACE {
        sum(second, &[1.0 - u - v, u, v])
    } else {
        sum(second, &[1.0 - v, v])
    };
    [time, u, v, nx, ny, nz, px, py, pz, qx, qy, qz]
}

/// The sum of points with weights that add up to 1: between the points, though rounding may lead beyond them,
/// and beyond the largest f64. So a single point is the sum, whatever its weight.
fn sum(points: &[Point], weights: &[f64]) -> Point {
    [0, 1, 2].map(|axis| {
        let values = points.iter().map(|point| point[axis]);
        let sum: f64 = values.clone().zip(weights).map(|(x, weight)| weight * x).sum();
        sum.max(values.clone().fold(f64::INFINITY, f64::min))
            .min(values.fold(f64::NEG_INFINITY, f64::max))
    })
}
