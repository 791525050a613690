//! The constants of the error bounds.
//!
//! `docs/filters.md` has the model that all bounds follow: roundings, overflow, underflow and NaN. u = 2⁻⁵³
//! is the unit roundoff, and n the largest number of roundings between the input and a result.

use core::cmp::Ordering;

/// The unit roundoff u.
pub(crate) const UNIT: f64 = f64::EPSILON / 2.0;

/// The error of n roundings, in units of u and relative to the magnitudes of all terms: the least power of
/// two that is at least a quarter above n.
///
/// It is at least n + 1. Hence a bound with k roundings of its own is at least (n + 1) (1 − k u) u of the
/// exact magnitude, and exceeds γₙ = n u / (1 − n u) while (n + 1) (n + k) u < 1: for all n and k below 2²⁰.
pub(crate) const fn margin(n: u32) -> f64 {
    (n + n.div_ceil(4)).next_power_of_two() as f64
}

/// The range of the filters, as a power of two. Up to 212, [`UNDERFLOW`] is above all that underflows.
const RANGE: u64 = 200;

/// 2²⁰⁰: the largest difference of two coordinates that the filters work on.
pub(crate) const LARGEST: f64 = f64::from_bits((1023 + RANGE) << 52);

/// 2⁻⁶⁰⁰, the volume of a cube with the side 1 / [`LARGEST`]: above 1000 errors of 2⁻¹⁰⁷⁵, each enlarged by
/// two factors of 2 · [`LARGEST`].
pub(crate) const UNDERFLOW: f64 = f64::from_bits((1023 - 3 * RANGE) << 52);

/// The sign of a number that differs from `value` by at most `error`; `None` if it may be zero or
/// of either sign.
#[inline(always)]
pub(crate) fn certain_sign(value: f64, error: f64) -> Option<Ordering> {
    (value.abs() > error).then(|| value.total_cmp(&0.0))
}
