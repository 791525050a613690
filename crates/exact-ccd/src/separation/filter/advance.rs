//! Advancement: stretches of time, from the left, in which a direction keeps the primitives farther
//! than d apart.

use super::closest::{Closest, dot};
use super::corners::Scaled;
use crate::filter::{UNDERFLOW, UNIT};
use crate::kind::Kind;
use crate::point::Point;

/// The outcome of advancement.
pub(super) enum Advance {
    /// The distance is less than d at t = 0.
    Within,
    /// The distance is above d at all times.
    Free,
    /// The distance is above d from t = 0 up to this time, and not much farther.
    Until(f64),
}

/// Advances from t = 0 in steps, each with one direction.
///
/// The direction of a step is that between the closest points at its start. It proves D > d as long as
/// all corners, which move at constant speed, are beyond d along it. Few steps settle most queries. A
/// crossing needs directions that turn.
pub(super) fn from_start<K: Kind>(scaled: &Scaled) -> Advance {
    const STEPS: usize = 4;
    let mut free = None;
    for _ in 0..STEPS {
        let t = free.unwrap_or(0.0);
        let corners = scaled.corners_at(t);
        let closest = Closest::guess::<K>(&corners);
        if free.is_none() && is_within(scaled, closest.point(&corners)) {
            return Advance::Within;
        }
        match free_until(scaled, K::FEATURES.vertices.len(), closest.direction(&corners), t) {
            Some(1.0) => return Advance::Free,
            Some(later) if later > t || free.is_none() => free = Some(later),
            _ => break,
        }
    }
    // Without any proof, even at t = 0, the result is 0. `Until` is a guess then.
    free.map_or(Advance::Until(0.0), Advance::Until)
}

/// True if |x| < d for x = F(0, u, v), of which this is an approximation.
///
/// x is a combination of corners below 1, each rounded once, with at most three products and sums:
/// n = 8 on each axis, on terms that add up to at most 5 (corners, and differences of two of them).
fn is_within(scaled: &Scaled, x: Point) -> bool {
    const ERROR: f64 = 64.0 * UNIT;
    let reach = x.map(|component| component.abs() + ERROR);
    dot(reach, reach) * (1.0 + 8.0 * UNIT) < scaled.d * scaled.d && scaled.d_is_exact
}

/// The time up to which a direction proves D > d from t on; `None` if it does not at t.
///
/// A corner is beyond d along g at t if (1 − t) m₀ + t m₁ > 0 for m = g · x − d |g|. With e the sum
/// of the products of |g| and the reach on each axis, m is off by at most 4 u e for the scalar
/// product (one rounding of the corner, a product and two sums), 5 u d |g| for the other term (four
/// roundings in |g|² and its root, one product) and u (e + d |g|) for the difference. The
/// interpolation adds 4 u times the larger |m|. All of it is less than 16 u (e + d |g|).
fn free_until(scaled: &Scaled, count: usize, g: Point, t: f64) -> Option<f64> {
    let squared_length = dot(g, g);
    // Below, its products underflow, and its error is not relative.
    if squared_length.is_nan() || squared_length < UNDERFLOW {
        return None;
    }
    let threshold = scaled.d * libm::sqrt(squared_length);
    let extent = g[0].abs() * scaled.reach[0] + g[1].abs() * scaled.reach[1] + g[2].abs() * scaled.reach[2];
    let error = 32.0 * UNIT * (extent + threshold) + UNDERFLOW;
    let margin = |x: Point| dot(g, x) - threshold - error;
    let mut until = 1.0;
    for (&start, &end) in scaled.at[0].iter().zip(&scaled.at[1]).take(count) {
        let (start, end) = (margin(start), margin(end));
        let now = (1.0 - t) * start + t * end;
        if now.is_nan() || now <= 0.0 {
            return None;
        }
        if end <= 0.0 {
            // A little before the margin is used up.
            let crossing = start / (start - end) * (1.0 - 8.0 * UNIT);
            until = if crossing < until { crossing } else { until };
        }
    }
    let holds = |time: f64| {
        let both = scaled.at[0].iter().zip(&scaled.at[1]).take(count);
        both.into_iter()
            .all(|(&start, &end)| (1.0 - time) * margin(start) + time * margin(end) > 0.0)
    };
    Some(if until > t && holds(until) { until } else { t })
}
