//! The closest features of a point and an edge.

use nalgebra::Vector3;

use super::feature::Feature;

/// The closest features of a point and an edge, given by their indices among the four points.
///
/// The features are the point and the line of the edge, if the closest point lies inside the edge, or else
/// the point and the closer end.
pub(crate) fn point_edge(points: &[Vector3<f64>; 4], point: usize, from: usize, to: usize) -> Feature {
    let edge = points[to] - points[from];
    let foot = edge.dot(&(points[point] - points[from]));
    if foot <= 0.0 {
        Feature::point_point(point, from)
    } else if foot >= edge.norm_squared() {
        Feature::point_point(point, to)
    } else {
        Feature::point_line(point, from, to)
    }
}
