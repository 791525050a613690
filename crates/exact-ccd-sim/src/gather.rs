//! The positions of the vertices of one element.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

/// The positions of some vertices.
pub(crate) fn gather<const N: usize>(points: &[Point], vertices: &[u32; N]) -> [Vector3<f64>; N] {
    vertices.map(|vertex| Vector3::from(points[vertex as usize]))
}

/// The positions of at most four vertices. The missing ones are zero; their weights are zero too.
pub(crate) fn gather_some(points: &[Point], vertices: &[u32]) -> [Vector3<f64>; 4] {
    let at = |place: usize| {
        let vertex = vertices.get(place);
        vertex.map_or_else(Vector3::zeros, |&vertex| Vector3::from(points[vertex as usize]))
    };
    [at(0), at(1), at(2), at(3)]
}
