//! A guess of the direction to the nearest point, without a branch for each query.

use crate::numbers::number::Lanes;
use crate::numbers::vector::{cross, dot, minus, select, towards};
use crate::tables::Tables;

/// A vector across the features of the closest points at one time: [`Closest`](super::closest::Closest)
/// for queries side by side.
///
/// The two are not one function. That one returns the features, by which a first time is refined in other
/// precisions: it is done where the inner points are closest, and the branches that choose among features
/// depend on the query. Here all features are examined in each lane, and only a direction remains.
#[inline(always)]
pub(super) fn nearest<K: Tables, T: Lanes>(corners: &[[T; 3]; 4]) -> [T; 3] {
    let features = K::FEATURES;
    let origin = corners[0];
    let (zero, one) = (origin[0].splat(0.0), origin[0].splat(1.0));
    let mut nearest = origin;
    let mut least = dot(origin, origin);
    for side in features.sides {
        let [i, j] = side.corners;
        let (x, e) = (corners[i], minus(corners[j], corners[i]));
        let s = -dot(x, e) / dot(e, e);
        // In this order, a NaN becomes 0.
        let s = T::select(s.gt(zero), s, zero);
        let s = T::select(s.gt(one), one, s);
        let point = towards(x, e, s);
        let square = dot(point, point);
        let is_less = least.gt(square);
        nearest = select(is_less, point, nearest);
        least = T::select(is_less, square, least);
    }
    let Some([i, j]) = features.inner else {
        return nearest;
    };
    let (a, b) = (minus(corners[i], origin), minus(corners[j], origin));
    let (aa, ab, bb) = (dot(a, a), dot(a, b), dot(b, b));
    let (ca, cb) = (dot(origin, a), dot(origin, b));
    // The parameters of the nearest point of the plane, times the determinant.
    let determinant = aa * bb - ab * ab;
    let (u, v) = (ab * cb - bb * ca, ab * ca - aa * cb);
    let is_below = if features.are_of_triangle() {
        determinant.gt(u + v)
    } else {
        determinant.gt(u) & determinant.gt(v)
    };
    let is_inner = determinant.gt(zero) & u.gt(zero) & v.gt(zero) & is_below;
    if !T::any(is_inner) {
        return nearest;
    }
    let n = cross(a, b);
    let faces_away = zero.gt(dot(n, origin));
    select(is_inner, select(faces_away, [-n[0], -n[1], -n[2]], n), nearest)
}
