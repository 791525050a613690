//! Advancement: stretches of time, from the left, in which a turning direction keeps the primitives
//! farther than d apart.

use super::closest::Closest;
use super::corners::Scaled;
use super::turning::{Moment, limit};
use crate::filter::{UNIT, dot};
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

/// A stretch of time is cut into at most two to this power of pieces.
const DEPTH: u32 = 5;

/// Advances from t = 0, in stretches that are cut in the middle where the directions at their ends prove
/// nothing.
pub(super) fn from_start<K: Kind>(scaled: &Scaled) -> Advance {
    let corners = scaled.corners_at(0.0);
    let closest = Closest::guess::<K>(&corners);
    if is_within(scaled, closest.point(&corners)) {
        return Advance::Within;
    }
    let start = Moment::new(corners, closest.direction(&corners));
    let limit = limit(scaled.d, scaled.reach);
    let stretch = Stretch { scaled, limit };
    let free = stretch.free_until::<K>((0.0, &start), (1.0, &stretch.at::<K>(1.0)), DEPTH);
    if free == 1.0 {
        Advance::Free
    } else {
        Advance::Until(free)
    }
}

/// True if the distance is certainly above d from one time to another.
pub(super) fn is_beyond<K: Kind>(scaled: &Scaled, start: f64, end: f64, depth: u32) -> bool {
    let limit = limit(scaled.d, scaled.reach);
    let stretch = Stretch { scaled, limit };
    let [first, last] = [start, end].map(|t| stretch.at::<K>(t));
    stretch.free_until::<K>((start, &first), (end, &last), depth) == end
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

struct Stretch<'a> {
    scaled: &'a Scaled,
    limit: f64,
}

impl Stretch<'_> {
    /// A corner results from that of the query, 1 − t, a product and a sum: four roundings.
    fn at<K: Kind>(&self, t: f64) -> Moment<f64> {
        let corners = self.scaled.corners_at(t);
        Moment::new(corners, Closest::guess::<K>(&corners).direction(&corners))
    }

    /// The time up to which the distance is certainly above d, from one time to at most another.
    fn free_until<K: Kind>(
        &self,
        (start, first): (f64, &Moment<f64>),
        (end, last): (f64, &Moment<f64>),
        depth: u32,
    ) -> f64 {
        if first.are_beyond_until::<K>(last, self.limit) {
            return end;
        }
        let middle = 0.5 * (start + end);
        if depth == 0 || middle <= start || middle >= end {
            return start;
        }
        let between = self.at::<K>(middle);
        let free = self.free_until::<K>((start, first), (middle, &between), depth - 1);
        if free < middle {
            return free;
        }
        self.free_until::<K>((middle, &between), (end, last), depth - 1)
    }
}
