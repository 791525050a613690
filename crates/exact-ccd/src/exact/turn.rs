//! Rigid motion with a linear quaternion.

use core::cmp::Ordering;

use dashu_int::IBig;

use super::dyadic::{in_unit, unit_of};
use crate::tables::Point;

/// The motion of a body in a step: it turns by q = s q₀ + t q₁, quaternions with the scalar first that need
/// not have length 1, and its origin moves on a Bézier curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Turn<'a> {
    pub(crate) quaternions: [[f64; 4]; 2],
    /// The control points of the place of the origin.
    pub(crate) places: &'a [Point],
}

/// Two quaternions as integers of one unit: their common length does not matter.
pub(super) fn in_integers([start, end]: [[f64; 4]; 2]) -> [[IBig; 4]; 2] {
    let unit = unit_of(start.into_iter().chain(end));
    [start, end].map(|quaternion| quaternion.map(|x| in_unit(x, unit)))
}

/// Returns true if one quaternion is a multiple of the other.
pub(super) fn are_parallel([a, b]: &[[IBig; 4]; 2]) -> bool {
    (1..4).all(|i| (0..i).all(|j| &a[i] * &b[j] == &a[j] * &b[i]))
}

/// The sign of q₀ · q₁: negative if the opposite of q₁, which is the same rotation, is nearer to q₀.
pub(crate) fn cosine_sign(quaternions: [[f64; 4]; 2]) -> Ordering {
    let [a, b] = in_integers(quaternions);
    let product = a.iter().zip(&b).fold(IBig::ZERO, |sum, (a, b)| sum + a * b);
    product.cmp(&IBig::ZERO)
}

/// Returns true if s q₀ + t q₁ vanishes inside the step, for quaternions that are not 0.
pub(crate) fn vanishes(quaternions: [[f64; 4]; 2]) -> bool {
    cosine_sign(quaternions).is_lt() && are_parallel(&in_integers(quaternions))
}
