//! The closest features of a point and a triangle.

use nalgebra::Vector3;

use super::feature::Feature;

/// The closest features of a point (the first) and a triangle (the last three points).
///
/// Source of the classification of the triangle's regions: C. Ericson, *Real-Time Collision Detection*,
/// section 5.1.5.
pub(crate) fn point_triangle(points: &[Vector3<f64>; 4]) -> Feature {
    let [p, a, b, c] = *points;
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return Feature::point_point(0, 1);
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    if d3 >= 0.0 && d4 <= d3 {
        return Feature::point_point(0, 2);
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    if d6 >= 0.0 && d5 <= d6 {
        return Feature::point_point(0, 3);
    }
    if d1 >= 0.0 && d3 <= 0.0 && d1 * d4 - d3 * d2 <= 0.0 {
        return Feature::point_line(0, 1, 2);
    }
    if d2 >= 0.0 && d6 <= 0.0 && d5 * d2 - d1 * d6 <= 0.0 {
        return Feature::point_line(0, 1, 3);
    }
    if d4 - d3 >= 0.0 && d5 - d6 >= 0.0 && d3 * d6 - d5 * d4 <= 0.0 {
        return Feature::point_line(0, 2, 3);
    }
    Feature::point_plane()
}
