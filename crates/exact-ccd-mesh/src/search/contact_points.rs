//! The places of contacts.

use exact_ccd::{Impact, Point};

/// The points of two primitives that touch or are closest at the time of an impact; `None` if a vertex has no
/// position.
///
/// `primitives` are the vertices of both, in the order of the query: one for a vertex, two for an edge,
/// three for a face. `positions` are the positions of all vertices at t = 0 and at t = 1.
///
/// The points are rounded: at contact, both are the same point up to a few ε of the largest coordinate, and
/// up to the error of the [parameters](Impact::parameters). So they are for pictures and tables, not for
/// decisions.
///
/// ```
/// use exact_ccd_mesh::{contact_points, step, TriangleMesh};
///
/// let mesh = TriangleMesh::new(4, vec![[0, 1, 2]])?;
/// let at = |z: f64| [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0], [2.0, 1.0, z]];
/// let (x0, x1) = (at(1.0), at(-1.0));
/// let contact = step(&mesh, &x0, &x1)?.earliest.expect("the point falls through the face");
/// let vertices = contact.pair.vertices(&mesh).expect("the pair is one of the mesh");
/// let (point, face) = vertices.split_at(contact.pair.kind().sizes()[0]);
/// let points = contact_points([point, face], [&x0, &x1], &contact.impact);
/// assert_eq!(points, Some([[2.0, 1.0, 0.0]; 2]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn contact_points(
    primitives: [&[u32]; 2],
    positions: [&[Point]; 2],
    impact: &Impact,
) -> Option<[Point; 2]> {
    let (time, [u, v]) = (impact.time.lower(), impact.parameters);
    let at = |vertex: u32| -> Option<Point> {
        let [a, b] = positions.map(|x| x.get(vertex as usize).copied());
        Some(mean([(1.0 - time, a?), (time, b?)]))
    };
    let on = |primitive: &[u32], place: f64| -> Option<Point> {
        match *primitive {
            [a, b, c] => Some(mean([(1.0 - u - v, at(a)?), (u, at(b)?), (v, at(c)?)])),
            [a, b] => Some(mean([(1.0 - place, at(a)?), (place, at(b)?)])),
            [a] => at(a),
            _ => None,
        }
    };
    let [first, second] = primitives;
    // On two edges, u is the place on the first one.
    Some([on(first, u)?, on(second, v)?])
}

/// The sum of points with weights that add up to 1. It is a point between them, except that rounding may
/// lead beyond them, and beyond the largest f64.
fn mean<const N: usize>(points: [(f64, Point); N]) -> Point {
    [0, 1, 2].map(|axis| {
        let values = points.map(|(_, point)| point[axis]);
        let sum: f64 = points.iter().map(|(weight, point)| weight * point[axis]).sum();
        sum.max(values.into_iter().fold(f64::INFINITY, f64::min))
            .min(values.into_iter().fold(f64::NEG_INFINITY, f64::max))
    })
}

#[cfg(test)]
mod tests {
    use super::mean;

    #[test]
    fn a_mean_is_between_its_points() {
        let mut random = fastrand::Rng::with_seed(83);
        for size in [1.0, f64::MAX, 3.0 * f64::from_bits(1)] {
            for _ in 0..1000 {
                let (u, v) = (random.f64(), 0.5 * random.f64());
                let weights = [1.0 - u - (1.0 - u) * v, u, (1.0 - u) * v];
                let points = weights.map(|weight| (weight, [size, -size, size * random.f64()]));
                let [x, y, z] = mean(points);
                let heights = points.map(|(_, point)| point[2]);
                assert_eq!([x, y], [size, -size]);
                assert!(
                    heights.iter().any(|&height| height <= z) && heights.iter().any(|&height| z <= height)
                );
            }
        }
        assert_eq!(
            mean([(0.25, [8.0, 0.0, 4.0]), (0.75, [0.0, 8.0, 4.0])]),
            [2.0, 6.0, 4.0]
        );
    }
}
