//! Parameters and normal of a contact at a root: of the coplanarity cubic, or of a side in a plane.

use super::position::{NearRoot, longest};
use crate::numbers::cubic::Root;
use crate::tables::{Point, Points, Side, Tables};
use crate::values::unit;

/// 2⁻³³: the largest error of the parameters and the normal. It is half of the documented one,
/// which leaves room for the roundings that are not counted here.
pub(super) const TOLERANCE: f64 = f64::from_bits((1023 - 33) << 52);

/// (u, v) and the normal at a root at which the primitives touch, if they are accurate enough.
pub(super) fn parameters_and_normal<K: Tables>(
    points: &Points<f64>,
    root: &Root,
) -> Option<([f64; 2], Point)> {
    let bracket = NearRoot::new(points, root);
    let [_, e1, e2] = K::SPAN.map(|difference| bracket.vector(difference));
    let normal = bracket.cross(&e1, &e2);
    let magnitude = |axis: usize| normal[axis].value.abs();
    let axis = longest(&normal);

    // For vectors n and n + d, n ≠ 0, the unit vectors differ by at most 2 |d| / |n|.
    let error = normal.iter().fold(0.0, |sum, component| sum + component.error);
    if !is_small(2.0 * error, magnitude(axis)) {
        return None;
    }
    // c changes its sign at the root: just before, w · n is negative if c is rising.
    let towards_first = if root.before.is_lt() {
        -magnitude(axis)
    } else {
        magnitude(axis)
    };
    let direction = unit([0, 1, 2].map(|k: usize| normal[k].value / towards_first));

    let mut parameters = [0.0; 2];
    for (parameter, index) in parameters.iter_mut().zip(K::PARAMETERS) {
        let side = &K::SIDES[index];
        let [x, y] = side.edge.map(|end| bracket.vector((end, side.vertex)));
        let area = bracket.cross_along(axis, &x, &y);
        let ratio = area.value / normal[axis].value;
        // For r = a / n, the exact (a + α) / (n + ν) is off by (α − r ν) / (n + ν).
        let error = area.error + ratio.abs() * normal[axis].error;
        if !is_small(error, magnitude(axis) - normal[axis].error) {
            return None;
        }
        // The exact parameter is in [0, 1]. Its zero is positive.
        let ratio = if side.along { ratio } else { -ratio };
        *parameter = if ratio > 0.0 { ratio.min(1.0) } else { 0.0 };
    }
    Some((parameters, direction))
}

/// (u, v) and the normal at a root at which a vertex reaches the line of an edge between its ends, in a plane
/// with the axes i and j, if they are accurate enough.
///
/// For an edge e from x and the offset o of the vertex from x, the area of the side is e × o: it rises where
/// the vertex moves along (−eⱼ, eᵢ) relative to the point at which it meets the edge.
pub(super) fn vertex_on_edge(
    points: &Points<f64>,
    [i, j]: [usize; 2],
    side: &Side,
    root: &Root,
) -> Option<([f64; 2], Point)> {
    let [x, y] = side.edge;
    let bracket = NearRoot::new(points, root);
    let [offset, edge] = [(side.vertex, x), (y, x)].map(|difference| bracket.vector(difference));
    let [along_i, along_j] = [i, j].map(|axis| bracket.component(&edge, axis));
    let axis = if along_i.value.abs() > along_j.value.abs() {
        i
    } else {
        j
    };
    let [above, below] = [&offset, &edge].map(|vector| bracket.component(vector, axis));
    let length = below.value.abs();
    let ratio = above.value / below.value;
    let error = above.error + ratio.abs() * below.error;
    // A quotient of α and ν with errors a and n, of ratio r, is off by at most (a + r n) / (ν − n). For
    // vectors n and n + d, n ≠ 0, the unit vectors differ by at most 2 |d| / |n|, where n may be either.
    let is_accurate =
        is_small(error, length - below.error) && is_small(2.0 * (along_i.error + along_j.error), length);
    let ratio = if ratio > 0.0 { ratio.min(1.0) } else { 0.0 };
    let is_of_first = side.vertex < x;
    let against = if root.before.is_lt() == is_of_first {
        length
    } else {
        -length
    };
    let mut normal = [0.0; 3];
    normal[i] = along_j.value / against;
    normal[j] = -along_i.value / against;
    is_accurate.then(|| (side.parameters(ratio), unit(normal)))
}

fn is_small(error: f64, magnitude: f64) -> bool {
    error <= TOLERANCE * magnitude
}
