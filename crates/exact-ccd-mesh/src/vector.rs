//! Vectors in space, in floating point, rounded: nothing here decides contact.

use exact_ccd::Point;

/// a − b.
#[must_use]
pub fn minus(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|axis: usize| a[axis] - b[axis])
}

/// a · b.
#[must_use]
pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a × b.
#[must_use]
pub fn cross(a: Point, b: Point) -> Point {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]: [usize; 2]| a[i] * b[j] - a[j] * b[i])
}

/// The unit vector in the direction of a vector; `None` if the vector is zero or not finite. The division by
/// the greatest component keeps the squares from overflow and underflow.
#[must_use]
pub fn unit(vector: Point) -> Option<Point> {
    let most = vector.into_iter().map(f64::abs).fold(0.0, f64::max);
    let scaled = vector.map(|x| x / most);
    let length = dot(scaled, scaled).sqrt();
    let unit = scaled.map(|x| x / length);
    unit.iter().all(|x| x.is_finite()).then_some(unit)
}
