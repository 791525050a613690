//! Parameters and normal of a contact at a root of the coplanarity cubic.

use super::cubic::Root;
use super::position::{NearRoot, longest};
use crate::impact::unit;
use crate::kind::Kind;
use crate::point::Point;
use crate::query::Query;

/// 2⁻³³: the largest error of the parameters and the normal. It is half of the documented one,
/// which leaves room for the roundings that are not counted here.
const TOLERANCE: f64 = f64::from_bits((1023 - 33) << 52);

/// (u, v) and the normal at a root at which the primitives touch, if they are accurate enough.
pub(super) fn parameters_and_normal<K: Kind>(query: &Query<K>, root: &Root) -> Option<([f64; 2], Point)> {
    let bracket = NearRoot::new(query, root);
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
    let towards_first = if root.rising {
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

fn is_small(error: f64, magnitude: f64) -> bool {
    error <= TOLERANCE * magnitude
}
