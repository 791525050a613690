//! Vectors in space.

use exact_ccd::Point;

pub(crate) fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The point at this fraction of the segment from a to b.
pub(crate) fn between(a: Point, b: Point, part: f64) -> Point {
    [0, 1, 2].map(|axis: usize| (1.0 - part) * a[axis] + part * b[axis])
}

pub(crate) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Point, b: Point) -> Point {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
