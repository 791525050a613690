//! The cubic c(t) = w · (e₁ × e₂), which vanishes when the primitives lie in one plane.

use super::cubic::Cubic;
use super::double_double::DoubleDouble;
use super::number::{Lanes, Number, Points, reach, subtract};
use super::precise_cubic::PreciseCubic;
use crate::kind::Kind;
use crate::query::Query;

/// c, and the normals from which it is computed.
pub(super) struct Coplanarity<T> {
    pub(super) cubic: Cubic<T>,
    /// e₁ × e₂ at t = 0 and at t = 1.
    pub(super) normals: [[T; 3]; 2],
}

/// c = b₀ (1−t)³ + 3 b₁ (1−t)² t + 3 b₂ (1−t) t² + b₃ t³.
struct Expansion<T: Number> {
    /// b₀, 3 b₁, 3 b₂, b₃. The longest chain of roundings leads to 3 b₁ and 3 b₂: a difference, a
    /// product, the difference in `cross`, the sum in `mixed`, a product, two sums in `dot` and one
    /// more; and the two other differences in each term.
    coefficients: [T; 4],
    magnitude: T::Real,
    normals: [[T; 3]; 2],
}

impl<T: Lanes> Coplanarity<T> {
    #[inline(always)]
    pub(super) fn new<K: Kind>(points: &Points<T>) -> Self {
        let expansion = Expansion::<T>::new::<K>(points);
        Self {
            cubic: Cubic::new(expansion.coefficients, expansion.magnitude),
            normals: expansion.normals,
        }
    }
}

/// c in twice the precision.
pub(super) fn precise<K: Kind>(query: &Query<K>) -> PreciseCubic {
    let expansion = Expansion::<DoubleDouble>::new::<K>(query.points());
    PreciseCubic::new(expansion.coefficients, expansion.magnitude)
}

impl<T: Number> Expansion<T> {
    #[inline(always)]
    fn new<K: Kind>(points: &Points<T::Real>) -> Self {
        let w = subtract::<T>(points, K::SPAN[0]);
        let e1 = subtract::<T>(points, K::SPAN[1]);
        let e2 = subtract::<T>(points, K::SPAN[2]);
        let normals = [cross(e1[0], e2[0]), cross(e1[1], e2[1])];
        // Twice the blossom of e₁ × e₂ at (0, 1).
        let mixed = add(cross(e1[0], e2[1]), cross(e1[1], e2[0]));
        let coefficients = [
            dot(w[0], normals[0]),
            dot(w[1], normals[0]) + dot(w[0], mixed),
            dot(w[0], normals[1]) + dot(w[1], mixed),
            dot(w[1], normals[1]),
        ];
        let (w, e1, e2) = (reach(&w), reach(&e1), reach(&e2));
        let magnitude = w[0] * (e1[1] * e2[2] + e1[2] * e2[1])
            + w[1] * (e1[2] * e2[0] + e1[0] * e2[2])
            + w[2] * (e1[0] * e2[1] + e1[1] * e2[0]);
        Self {
            coefficients,
            magnitude,
            normals,
        }
    }
}

#[inline(always)]
fn add<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
fn dot<T: Number>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
