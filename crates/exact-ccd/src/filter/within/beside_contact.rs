//! Small distances: the first time within d is next to the first contact.
//!
//! Contact implies a distance of at most d. Let f be the largest f64 before the first contact. If D > d until
//! f, then the first time within d is between f and the next f64, because D is continuous and d > 0.
//! Directions prove most of it, and the planes the rest: with c = w · n and n = e₁ × e₂, D is at least |c| /
//! |n|.

use super::advance::Advancement;
use super::scaled::Scaled;
use crate::filter::coplanarity::{self, Coplanarity};
use crate::filter::decision::{Decision, Proved};
use crate::filter::hull::Hull;
use crate::filter::near_plane::decide_near_plane;
use crate::filter::{Touching, Within};
use crate::numbers::number::Lanes;
use crate::numbers::roundoff::{UNIT, margin};
use crate::tables::{Points, Tables};
use crate::values::ContactTime;

/// The first time within d, if the first contact determines it, when D > d is known before the time `free`.
pub(super) fn first_after<K: Tables>(
    points: &Points<f64>,
    hull: &Hull<f64>,
    scaled: &Scaled,
    d: f64,
    free: f64,
) -> Option<ContactTime> {
    // Contact is decided for boxes that meet.
    if hull.is_out_of_range(Within(d)) || hull.is_beyond_axis(Touching) {
        return None;
    }
    let planes = Coplanarity::new::<K>(points);
    let Decision::Collision(Proved::Contact(contact)) = decide_near_plane::<K>(points, &planes.cubic, 1.0)
    else {
        return None;
    };
    let contact = contact.first::<K>(points)?;
    if contact.is_start() {
        return Some(contact);
    }
    let floor = if contact.is_exact() {
        contact.lower().next_down()
    } else {
        contact.lower()
    };
    let start = Advancement::of(scaled).free_after::<K>(free.min(floor), floor);
    are_planes_beyond::<K>(points, &planes, d, [start, floor, contact.upper()])
        .then(|| ContactTime::just_above(floor))
}

/// Returns true if the planes certainly are farther than d apart from one time to a second one, given a third
/// one until which c vanishes.
///
/// If c is monotone until then, its magnitude is least at the second time.
fn are_planes_beyond<K: Tables>(
    points: &Points<f64>,
    planes: &Coplanarity<f64>,
    d: f64,
    [from, to, contact]: [f64; 3],
) -> bool {
    let least = least_volume(d, planes.extent);
    planes.cubic.is_monotone(from, contact) && coplanarity::precise::<K>(points).exceeds(to, least)
}

/// A bound of d |n|, apart from underflow, for which the error of the cubic has room: [`UNDERFLOW`].
///
/// A component of |n| is at most the sum of magnitudes that the extent adds up, so that |n| is at most the
/// extent. Two differences, a product and three sums lead to a term of that, and the bound has two roundings:
/// n = 8.
pub(super) fn least_volume<T: Lanes>(d: T, extent: T) -> T {
    d * extent * (1.0 + margin(8) * UNIT)
}
