//! Assertions about bounds.
//!
//! The inputs of a test make the magnitude of a bound equal to the permanent, so that the quotient of both is
//! the constant of the bound.

use super::Symbol;
use crate::numbers::roundoff::{LARGEST, UNIT};
use crate::tables::Points;

/// Points that are the opposite of themselves at the other time: magnitudes are equal at both.
pub(in crate::filter) fn opposite_points(seed: u64) -> Points<f64> {
    let mut random = fastrand::Rng::with_seed(seed);
    let start = [(); 4].map(|()| [(); 3].map(|()| random.f64() - 0.5));
    [start, start.map(|point| point.map(|x| -x))]
}

pub(in crate::filter) fn symbols(points: Points<f64>) -> Points<Symbol> {
    points.map(|now| now.map(|point| point.map(Symbol::input)))
}

/// The least power of two that is at least a quarter above n.
pub(in crate::filter) fn power(n: u32) -> f64 {
    (0..64)
        .map(|k| f64::from(k).exp2())
        .find(|&power| 4.0 * power >= f64::from(5 * n))
        .unwrap()
}

/// Asserts that a bound has the constant that n roundings require, for terms of this magnitude.
#[track_caller]
pub(in crate::filter) fn assert_bound(bound: f64, magnitude: f64, n: u32) {
    let units = bound / (UNIT * magnitude);
    assert!(
        (units - power(n)).abs() < 1e-9 * units,
        "{units} u of the magnitude for n = {n}"
    );
}

/// Asserts the largest number of roundings and the degree of values whose magnitudes are at most some sum.
#[track_caller]
pub(in crate::filter) fn assert_counts(values: &[Symbol], n: u32, degree: i32, magnitude: f64) {
    assert_eq!(values.iter().map(|value| value.roundings).max(), Some(n));
    for value in values {
        assert_eq!(value.degree, degree);
        assert!(
            value.permanent <= magnitude * (1.0 + 1e-9),
            "{} > {magnitude}",
            value.permanent
        );
        assert_in_range(value);
    }
}

/// Asserts that nothing overflows, and the bound of underflow.
#[track_caller]
pub(super) fn assert_in_range(value: &Symbol) {
    assert!(value.largest < f64::MAX, "{}", value.largest);
    let far = 2.0 * LARGEST;
    assert!(value.underflow <= 1000.0 * far * far, "{}", value.underflow);
}
