//! Floating-point filters of separation: each one proves an answer or returns that it is unknown.
//!
//! All proofs rest on two facts. With x = F(t, u, v) for parameters in the domain, the distance at
//! t is at most |x|. And for any vector g, the distance is at least the least of g · x / |g| over
//! the corners x of F at t, in whose hull F lies. Guesses of the closest points, which need no
//! bound, lead to good x and g.
//!
//! The conventions of the error bounds are those of the filters of contact. Corners are scaled by a
//! power of two so that the largest component is in [1/2, 1). Comparisons are written so that a NaN
//! proves nothing.

mod advance;
mod closest;
mod corners;
mod crossing;
mod moment;
mod nearest;
mod screening;
mod turning;

use super::{Separation, SeparationStage};
pub(crate) use screening::Screening;

use crate::environment;
use crate::filter::{UNIT, dot};
use crate::kind::Kind;
use crate::query::Query;
use crate::time::ContactTime;
use closest::Closest;
use corners::{Corners, Scaled};

/// The first time within d, or none, and the stage that proved it; `None` if that is unknown.
#[inline]
pub(super) fn first_within<K: Kind>(
    query: &Query<K>,
    d: Separation,
) -> Option<(Option<ContactTime>, SeparationStage)> {
    if !environment::is_default() {
        return None;
    }
    let corners = Corners::new(query);
    if corners.are_beyond_axis(d.get()) {
        return Some((None, SeparationStage::BoundingBox));
    }
    if corners.are_beyond_diagonal(d.get()) {
        return Some((None, SeparationStage::Diagonals));
    }
    let screening = Screening::new::<K>(query.points(), d.get());
    if screening.planes_are_beyond::<K>(query.points()) {
        return Some((None, SeparationStage::Planes));
    }
    let free = screening.free_until::<K>(1.0);
    if free == 1.0 {
        return Some((None, SeparationStage::Advancement));
    }
    first_of(query, &corners, d, [free, 1.0])
}

/// The same for a query whose primitives are known to be beyond d before the first of two times, until the
/// second one, which is above 0, in the default environment.
pub(super) fn first_between<K: Kind>(
    query: &Query<K>,
    d: Separation,
    times: [f64; 2],
) -> Option<(Option<ContactTime>, SeparationStage)> {
    first_of(query, &Corners::new(query), d, times)
}

/// Few candidates get here; apart, so that the stages above stay small.
#[inline(never)]
fn first_of<K: Kind>(
    query: &Query<K>,
    corners: &Corners,
    d: Separation,
    [free, until]: [f64; 2],
) -> Option<(Option<ContactTime>, SeparationStage)> {
    let scaled = corners.scaled(d.get())?;
    if free == 0.0 && starts_within::<K>(&scaled) {
        return Some((Some(ContactTime::exactly(0.0)), SeparationStage::Start));
    }
    let first = crossing::first_between(query, &scaled, [free, until])?;
    Some((first, SeparationStage::Crossing))
}

/// True if |x| < d for x = F(0, u, v) at a guess of the closest points.
///
/// x is a combination of corners below 1, each rounded once, with at most three products and sums:
/// n = 8 on each axis, on terms that add up to at most 5 (corners, and differences of two of them).
fn starts_within<K: Kind>(scaled: &Scaled) -> bool {
    const ERROR: f64 = 64.0 * UNIT;
    let [corners, _] = &scaled.at;
    let x = Closest::guess::<K>(corners).point(corners);
    let reach = x.map(|component| component.abs() + ERROR);
    dot(reach, reach) * (1.0 + 8.0 * UNIT) < scaled.d * scaled.d && scaled.d_is_exact
}
