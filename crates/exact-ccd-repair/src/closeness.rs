//! The weight of each edge in linear systems.

use exact_ccd_mesh::vector::{dot, minus};
use exact_ccd_mesh::{Point, TriangleMesh};

/// The largest closeness, and the inverse of the least one.
const MOST: f64 = 100.0;

/// For each edge, its closeness: the mean length of edges divided by the length of the edge.
pub(crate) fn closeness(mesh: &TriangleMesh, x: &[Point], mean_edge: f64) -> Vec<f64> {
    let of_edge = |&[a, b]: &[u32; 2]| {
        let edge = minus(x[a as usize], x[b as usize]);
        // An edge of length 0 has the largest closeness.
        (mean_edge / dot(edge, edge).sqrt()).clamp(1.0 / MOST, MOST)
    };
    mesh.edges().iter().map(of_edge).collect()
}
