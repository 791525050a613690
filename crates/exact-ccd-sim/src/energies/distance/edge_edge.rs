//! The closest features of two edges.

use nalgebra::Vector3;

use super::feature::Feature;
use super::point_edge::point_edge;

/// The closest features of two edges: the first two points and the last two.
///
/// The features are the two lines, if their closest points lie inside both edges. Otherwise, and for
/// parallel edges, they are the closest of the four pairs of an end and the other edge.
pub(crate) fn edge_edge(points: &[Vector3<f64>; 4]) -> Feature {
    let [a, b, c, d] = *points;
    let (u, v, w) = (b - a, d - c, a - c);
    let (uu, uv, vv) = (u.norm_squared(), u.dot(&v), v.norm_squared());
    let (uw, vw) = (u.dot(&w), v.dot(&w));
    let determinant = uu * vv - uv * uv;
    let (s, t) = (uv * vw - vv * uw, uu * vw - uv * uw);
    let inside = |x: f64| x > 0.0 && x < determinant;
    // The determinant of nearly parallel edges has no correct digit.
    if determinant > PARALLEL * uu * vv && inside(s) && inside(t) {
        return Feature::line_line();
    }

    let ends = [(0, 2, 3), (1, 2, 3), (2, 0, 1), (3, 0, 1)];
    let mut nearest = (f64::INFINITY, Feature::point_point(0, 2));
    for (point, from, to) in ends {
        let feature = point_edge(points, point, from, to);
        let squared = feature.shortest_vector(points).squared();
        if squared < nearest.0 {
            nearest = (squared, feature);
        }
    }
    nearest.1
}

/// The squared sine of the angle up to which edges count as parallel.
const PARALLEL: f64 = 1e-14;
