//! The last stages for a separation d above 0.
//!
//! All proofs rest on two facts. With x = F(t, u, v) for parameters in the domain, the distance at
//! t is at most |x|. And for any vector g, the distance is at least the least of g · x / |g| over
//! the corners x of F at t, in whose hull F lies. Guesses of the closest points, which need no
//! bound, lead to good x and g.
//!
//! Corners are scaled by a power of two so that the largest component is in [1/2, 1). Comparisons are
//! written so that a NaN proves nothing.

mod advance;
mod closest;
mod crossing;
mod nearest;
mod scaled;
mod snapshot;
mod turning;

pub(crate) use advance::free_until;

use super::hull::Hull;
use super::roundoff::UNIT;
use super::screening::{self, Decision, Proved};
use super::vector::dot;
use crate::distance::Separation;
use crate::kind::Kind;
use crate::options::{CONTACT, Options};
use crate::query::Query;
use crate::stage::Stage;
use crate::time::ContactTime;
use closest::Closest;
use scaled::Scaled;

/// The least time until which a step is examined, 2⁻⁶⁰. It is above 0, so that a proof that begins at t = 0
/// ends later; what is found after the time in question does not count.
pub(crate) const LEAST_UNTIL: f64 = f64::from_bits((1023 - 60) << 52);

/// Decides whether primitives come within a separation above 0, as far as the filters can.
#[inline]
pub(super) fn decide<K: Kind>(query: &Query<K>, hull: &Hull<f64>, options: &Options) -> Decision {
    let until = options.until.clamp(LEAST_UNTIL, 1.0);
    let free = free_until::<K, f64>(hull, options.separation.get(), until);
    if free < until {
        decide_by_hull(query, hull, options.separation, [free, until])
    } else {
        Decision::Free(Stage::Advancement)
    }
}

/// Decides a query of a batch whose primitives are known to be beyond d before the first of two times. A
/// collision after the second time, which is above 0, may be left out. If some vertices of the batch have the
/// thickness 0, d can be 0: then the stages of contact decide.
pub(crate) fn decide_between<K: Kind>(query: &Query<K>, d: Separation, times: [f64; 2]) -> Decision {
    if d.is_zero() {
        return screening::decide(query, &CONTACT);
    }
    decide_by_hull(query, &Hull::new::<K>(&query.four()), d, times)
}

/// Few candidates get here; apart, so that the stages above stay small.
#[inline(never)]
fn decide_by_hull<K: Kind>(
    query: &Query<K>,
    hull: &Hull<f64>,
    d: Separation,
    [free, until]: [f64; 2],
) -> Decision {
    // All corners are 0: the primitives are one point at both ends of the step.
    if hull.reaches() == [0.0; 3] {
        let start = ContactTime::exactly(0.0);
        return Decision::Collision(Proved::Within(start, Stage::Start));
    }
    let Some(scaled) = Scaled::new(hull, d.get()) else {
        return Decision::Unknown;
    };
    if free == 0.0 && starts_within::<K>(&scaled) {
        let start = ContactTime::exactly(0.0);
        return Decision::Collision(Proved::Within(start, Stage::Start));
    }
    match crossing::first_between(query, &scaled, [free, until]) {
        Some(Some(first)) => Decision::Collision(Proved::Within(first, Stage::Crossing)),
        Some(None) => Decision::Free(Stage::Crossing),
        None => Decision::Unknown,
    }
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
