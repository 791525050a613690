//! Rays from the origin, and the triangles that they cross (appendix A of the paper).
//!
//! A ray serves if it meets no triangle at its boundary. The paper casts another random one if it does; here, the
//! directions are (1, k, k²), k = 0, 1, 2, …, and one of the first few hundred always serves: each time that a direction is
//! rejected, it lies in the plane through the origin and an edge, or along the line through the origin and an edge.
//! No plane through the origin contains more than two of these directions, and no two of them are parallel, so that
//! each of the at most 36 planes and lines that a query has rejects two at most.

use core::cmp::Ordering;

use super::corner::Corner;

/// The k-th direction to try.
pub(super) fn direction<C: Corner>(k: u32) -> C {
    C::small([1, k, k * k])
}

/// Whether a ray from the origin crosses a triangle that does not contain the origin; `None` if it meets the triangle at
/// its boundary, or may.
pub(super) fn crosses<C: Corner>(ray: &C, [a, b, c]: [&C; 3]) -> Option<bool> {
    // The line crosses the plane of the triangle on one side of each edge.
    let mut sides = [Ordering::Equal; 3];
    for (index, [x, y]) in [[a, b], [b, c], [c, a]].into_iter().enumerate() {
        sides[index] = C::orientation(ray, x, y);
        if sides[..index].contains(&sides[index].reverse()) && sides[index].is_ne() {
            return Some(false);
        }
    }
    // The ray meets the plane in front of the origin if it is on the side of the normal on which the plane is.
    match C::orientation(a, b, c) {
        Ordering::Equal => is_apart(ray, [a, b, c], sides).then_some(false),
        facing if sides.contains(&facing.reverse()) => Some(false),
        facing => (sides == [facing; 3]).then_some(true),
    }
}

/// Whether a ray stays away from a triangle whose plane contains the origin: either it leaves the plane, or there is no
/// plane, and the triangle lies on a line through the origin in another direction.
fn is_apart<C: Corner>(ray: &C, corners: [&C; 3], sides: [Ordering; 3]) -> bool {
    let is_on_line = |line: &C| corners.iter().all(|corner| C::are_parallel(line, corner));
    sides.iter().any(|side| side.is_ne())
        || corners
            .into_iter()
            .find(|corner| !corner.is_zero())
            .is_none_or(|line| is_on_line(line) && !C::are_parallel(line, ray))
}
