//! Points that approach each other in straight lines.

use exact_ccd::Point;

use super::sphere::length;
use crate::vector::{dot, minus};

/// The distance within which two points count as near, at any time of a part of the step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limit {
    pub(super) distance: f64,
    /// A bound of the errors of distances, which are in `distance` too: 2⁻⁴⁴ of the magnitudes of both places
    /// or more.
    pub(super) error: f64,
}

/// A distance above all that underflows in squares.
pub(super) const TINY: f64 = 1e-140;

/// A time, from 0 to 1, before which two points are certainly farther apart than a limit; `None` if they are
/// at all times. The points move in straight lines between these places.
///
/// With D their difference at the start and E its change, |D + τ E| is least at τ = −D·E / |E|². An
/// error of τ by δ = 4 u (|D| / |E| + τ) makes the distance there greater by at most |E| δ; sums, squares and
/// the root have less than 20 roundings. Both are below 2⁻⁴⁶ (|D| + |E|), which is in the limit. They come
/// within the limit l at τ − r / |E|, r² = l² − m², m the least distance on the line, at the earliest.
#[inline]
pub(super) fn approach(first: [Point; 2], second: [Point; 2], limit: Limit) -> Option<f64> {
    let difference = minus(first[0], second[0]);
    let change = minus(minus(first[1], second[1]), difference);
    let at = |time: f64| length([0, 1, 2].map(|axis: usize| difference[axis] + time * change[axis]));
    let least = -dot(difference, change) / dot(change, change);
    // For 0 / 0, any time will do.
    let least = if least.is_nan() { 0.0 } else { least };
    let l = limit.distance;
    if at(least.clamp(0.0, 1.0)) > l {
        return None;
    }
    let m = at(least);
    let back = ((l - m) * (l + m)).max(0.0).sqrt() * (1.0 + 1e-12) + limit.error;
    let time = least - back / length(change) - 1e-12;
    // Also if it is not a number.
    Some(if time > 0.0 { time } else { 0.0 })
}
