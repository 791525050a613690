//! Positions along a direction.

use exact_ccd::Point;

/// The positions after a step along a direction: x + fl(α d), rounded.
#[must_use]
pub fn advance(start: &[Point], direction: &[Point], size: f64) -> Vec<Point> {
    let along = |(x, d): (&Point, &Point)| core::array::from_fn(|axis| x[axis] + size * d[axis]);
    start.iter().zip(direction).map(along).collect()
}
