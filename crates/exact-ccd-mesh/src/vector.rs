//! Vectors in space, in floating point, rounded: nothing here decides contact.

use std::ops::{Add, Mul, Sub};

use exact_ccd::Point;

/// a − b.
#[must_use]
#[inline]
pub fn minus(a: Point, b: Point) -> Point {
    difference(a, b)
}

/// a − b, in numbers of any kind.
#[inline]
pub(crate) fn difference<T: Copy + Sub<Output = T>>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [0, 1, 2].map(|axis: usize| a[axis] - b[axis])
}

/// a · b.
#[must_use]
#[inline]
pub fn dot(a: Point, b: Point) -> f64 {
    product(a, b)
}

/// a · b, in numbers of any kind.
#[inline]
pub(crate) fn product<T: Copy + Add<Output = T> + Mul<Output = T>>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a × b.
#[must_use]
#[inline]
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

/// The vectors that have a direction, as errors describe them.
pub const DIRECTION: &str =
    "three finite numbers, not all 0, of a length from about 1e-153 to 1e154, such as 1";

/// Returns true if a vector has a direction, see [`DIRECTION`]: the square of its length is a normal number.
#[must_use]
pub fn has_direction(vector: Point) -> bool {
    dot(vector, vector).is_normal()
}

#[cfg(test)]
mod tests {
    use super::{cross, dot, has_direction, unit};

    #[test]
    fn directions_have_lengths_whose_squares_are_normal() {
        for length in [1.0, 1e-153, 1e154] {
            assert!(has_direction([0.0, -length, 0.0]), "{length}");
        }
        for length in [0.0, 1e-155, 1e155, f64::INFINITY, f64::NAN] {
            assert!(!has_direction([0.0, 0.0, length]), "{length}");
        }
    }

    #[test]
    fn products_of_vectors() {
        let [a, b] = [[1.0, 2.0, 4.0], [-3.0, 5.0, 8.0]];
        assert_eq!(cross(a, b), [-4.0, -20.0, 11.0]);
        assert_eq!([dot(cross(a, b), a), dot(cross(a, b), b)], [0.0; 2]);
    }

    #[test]
    fn unit_vectors_of_any_length() {
        for size in [1.0, f64::MAX / 4.0, f64::MIN_POSITIVE] {
            let found = unit([0.0, -3.0, 4.0].map(|x| x * size)).expect("it is not zero");
            assert!(
                (0..3).all(|axis| (found[axis] - [0.0, -0.6, 0.8][axis]).abs() < 1e-15),
                "{found:?}"
            );
        }
        for none in [[0.0; 3], [f64::INFINITY, 1.0, 0.0], [1.0, f64::NAN, 0.0]] {
            assert_eq!(unit(none), None);
        }
    }
}
