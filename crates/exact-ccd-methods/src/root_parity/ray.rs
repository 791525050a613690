//! A ray from the origin, and its crossings with triangles.

use std::cmp::Ordering;

use super::image::{Image, Predicate, RAY};
use super::patch::stand_in;

/// True if the ray of an image proves a contact: if the origin is on a face, or the ray crosses the
/// faces an odd number of times. `None` if it meets the boundary of a triangle, so that its
/// crossings cannot be counted.
pub(super) fn cast(image: &impl Image, faces: &[[usize; 4]]) -> Option<bool> {
    let mut is_odd = Some(false);
    for &face in faces {
        let Some(triangles) = stand_in(image, face) else {
            return Some(true);
        };
        for triangle in triangles {
            is_odd = is_odd
                .zip(crosses(image, triangle))
                .map(|(is_odd, crosses)| is_odd ^ crosses);
        }
    }
    is_odd
}

/// True if the ray crosses a triangle that does not contain the origin; `None` if it meets the boundary.
///
/// The ray crosses the triangle if its volumes with the three edges have the sign of the volume of the
/// triangle.
fn crosses(image: &impl Image, [a, b, c]: [usize; 3]) -> Option<bool> {
    let edges = [[a, b], [b, c], [c, a]];
    let mut side = Ordering::Equal;
    let mut meets_line = false;
    for [from, to] in edges {
        let other = image.sign(Predicate::Volume([RAY, from, to]));
        if other.is_ne() && other == side.reverse() {
            return Some(false);
        }
        meets_line |= other.is_eq();
        side = side.then(other);
    }
    match image.sign(Predicate::Volume([a, b, c])) {
        // The ray leaves the plane of the triangle, or is in it.
        Ordering::Equal => {
            let meets = side.is_eq() && edges.into_iter().any(|edge| meets_in_plane(image, edge));
            (!meets).then_some(false)
        }
        facing if facing != side => Some(false),
        _ => (!meets_line).then_some(true),
    }
}

/// True if the ray meets an edge that is in one plane with it.
///
/// Seen along an axis, if the ends of the edge are not both on the line of the ray, they are on
/// different sides of it, or one is on it, and the turn from one end to the other is that from the
/// end to the ray, or a half turn. If both are on it, one is in front.
fn meets_in_plane(image: &impl Image, [a, b]: [usize; 2]) -> bool {
    for axis in 0..3 {
        let turn = |from: usize, to: usize| image.sign(Predicate::Turn(axis, [from, to]));
        let (to_ray, from_ray) = (turn(a, RAY), turn(RAY, b));
        let forward = to_ray.then(from_ray);
        if forward.is_ne() {
            return [to_ray, from_ray, turn(a, b)]
                .iter()
                .all(|&sign| sign != forward.reverse());
        }
    }
    [a, b]
        .into_iter()
        .any(|end| image.sign(Predicate::Dot([end, RAY])).is_ge())
}
