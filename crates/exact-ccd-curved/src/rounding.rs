//! Bounds of real numbers by f64.
//!
//! Results rounded to nearest have a relative error of at most u = 2⁻⁵³, or lie below the normal
//! range and have an absolute error of at most 2⁻¹⁰⁷⁵. On a thread with another [`environment`] nothing is
//! known: every bound that is computed there is infinite.

use exact_ccd::{Point, environment};

pub(crate) use crate::sine::UNIT;

/// 2⁻¹⁰⁰⁰: above the sum of 2⁶⁴ errors by underflow.
pub(crate) const FLOOR: f64 = f64::from_bits((1023 - 1000) << 52);

/// An upper bound of the real value of an expression that was computed as `value`.
///
/// The expression has operations +, ×, √ on non-negative operands, at most 64 on each path from an
/// operand to the result; a [`length`] counts as 8. Then the computed value is at least (1 − u)⁶⁴ ≥
/// 1 − 2⁻⁴⁷ of the real one, apart from underflow. The factor 1 + 2⁻⁴⁵ exceeds the inverse by more than
/// the rounding of the product and the sum here. NaN, from 0 · ∞ after an overflow, gives ∞.
pub(crate) fn above(value: f64) -> f64 {
    let bound = value * (1.0 + f64::EPSILON * 128.0) + FLOOR;
    if bound.is_nan() || !environment::is_default() {
        f64::INFINITY
    } else {
        bound
    }
}

/// The length of a vector, with a relative error of at most 8 u; NaN if a component is.
///
/// Components are divided by the largest, m, so that no square overflows. The quotients have a
/// relative error of u, their squares 3 u, the sum 5 u, its root 3.5 u and the product 4.5 u, to first
/// order. Squares that underflow are below 2⁻¹⁰²², and the sum is at least 1.
pub(crate) fn length(vector: Point) -> f64 {
    let largest = vector.into_iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    if vector.iter().any(|x| x.is_nan()) {
        return f64::NAN;
    }
    if largest == 0.0 || largest == f64::INFINITY {
        return largest;
    }
    let squares = vector.map(|x| (x / largest) * (x / largest));
    largest * libm::sqrt(squares[0] + squares[1] + squares[2])
}

/// a + b, rounded up, for non-negative numbers; exact if one of them is 0.
pub(crate) fn add_up(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 {
        a + b
    } else {
        (a + b).next_up()
    }
}

/// fl(a + b), and the absolute value of its rounding error, exactly (Knuth 1969); NaN after an
/// overflow.
pub(crate) fn sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    if !environment::is_default() {
        return (sum, f64::INFINITY);
    }
    let part = sum - a;
    (sum, ((a - (sum - part)) + (b - part)).abs())
}
