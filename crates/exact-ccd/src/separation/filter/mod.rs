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

use crate::environment::flushes_subnormals;
use crate::kind::Kind;
use crate::query::Query;
use crate::time::ContactTime;
use advance::Advance;
use corners::Corners;

/// The first time within d, or none, and the stage that proved it; `None` if that is unknown.
#[inline]
pub(super) fn first_within<K: Kind>(
    query: &Query<K>,
    d: Separation,
) -> Option<(Option<ContactTime>, SeparationStage)> {
    // The bounds assume gradual underflow.
    if flushes_subnormals() {
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
    if !screening.is_out_of_range() && screening.planes_are_beyond::<K>(query.points()) {
        return Some((None, SeparationStage::Planes));
    }
    first_after_planes(query, &corners, d)
}

/// The same for a query that the stages up to `Planes` have not settled, in an environment with
/// gradual underflow.
pub(super) fn first_near<K: Kind>(
    query: &Query<K>,
    d: Separation,
) -> Option<(Option<ContactTime>, SeparationStage)> {
    first_after_planes(query, &Corners::new(query), d)
}

/// Few candidates get here; apart, so that the stages above stay small.
#[inline(never)]
fn first_after_planes<K: Kind>(
    query: &Query<K>,
    corners: &Corners,
    d: Separation,
) -> Option<(Option<ContactTime>, SeparationStage)> {
    let scaled = corners.scaled(d.get())?;
    match advance::from_start::<K>(&scaled) {
        Advance::Within => Some((Some(ContactTime::exactly(0.0)), SeparationStage::Start)),
        Advance::Free => Some((None, SeparationStage::Advancement)),
        Advance::Until(free) => {
            let first = crossing::first_after(query, &scaled, free)?;
            Some((first, SeparationStage::Crossing))
        }
    }
}
