//! Planes through the origin that have all corners strictly on one side.

use std::cmp::Ordering;

use exact_ccd::Point;

use crate::interval::Enclosure;
use crate::vector::{Vector, cross, dot, minus};

/// The normals that are tried for any query: the axes, their pairs, and all three, as in El Topo.
const NORMALS: [Point; 7] = [
    [0.0, 0.0, 1.0],
    [0.0, 1.0, 0.0],
    [0.0, 1.0, 1.0],
    [1.0, 0.0, 0.0],
    [1.0, 0.0, 1.0],
    [1.0, 1.0, 0.0],
    [1.0, 1.0, 1.0],
];

/// Returns true if a plane separates the origin from the hull of the corners. It tries planes across fixed
/// directions, and planes along the two triangles of each face.
pub(super) fn separates(corners: &[Vector<Enclosure>; 8], faces: &[[usize; 4]]) -> bool {
    let middles = corners.map(|corner| corner.map(Enclosure::middle));
    let normals = faces
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
        .filter_map(|triangle| normal(triangle.map(|corner| middles[corner])));
    NORMALS
        .into_iter()
        .chain(normals)
        .any(|normal| is_on_one_side(corners, normal))
}

/// The unit normal of a triangle; `None` if it is not finite or zero in floating-point arithmetic.
fn normal([a, b, c]: [Point; 3]) -> Option<Point> {
    let normal = cross(&minus(&b, &a), &minus(&c, &a));
    let length = dot(&normal, &normal).sqrt();
    (length > 0.0 && length.is_finite()).then(|| normal.map(|x| x / length))
}

fn is_on_one_side(corners: &[Vector<Enclosure>; 8], normal: Point) -> bool {
    let normal = normal.map(Enclosure::from);
    let mut sides = corners.iter().map(|corner| dot(&normal, corner).sign());
    let first = sides.next().flatten();
    matches!(first, Some(Ordering::Less | Ordering::Greater)) && sides.all(|side| side == first)
}
