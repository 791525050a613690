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
mod approach;
mod beside_contact;
mod closest;
mod crossing;
mod intervals;
mod leaving;
mod nearest;
#[cfg(test)]
mod proof;
mod scaled;
mod snapshot;
#[cfg(test)]
mod statements;
mod turning;

pub(crate) use advance::free_until;

use super::decision::{Decision, Proved};
use super::hull::Hull;
use crate::numbers::number::Lanes;
use crate::numbers::roundoff::{UNIT, margin};
use crate::numbers::vector::dot;
use crate::tables::{Point, Points, Tables};
use crate::values::{ContactTime, Impact, Intervals, Options, Separation, Stage};
use advance::Advancement;
use closest::Closest;
use crossing::Crossings;
use scaled::Scaled;

/// The least time until which a step is examined, 2⁻⁶⁰. It is above 0, so that a proof that begins at t = 0
/// ends later; what is found after the time in question does not count.
pub(crate) const LEAST_UNTIL: f64 = f64::from_bits((1023 - 60) << 52);

/// 2⁻⁶⁰: the least scaled distance for which crossings are tried. Primitives pass through a smaller one
/// within one f64.
const LEAST_CROSSED: f64 = f64::from_bits((1023 - 60) << 52);

/// Decides whether primitives come within a separation above 0, as far as the filters can.
#[inline(never)]
pub(super) fn decide<K: Tables>(points: &Points<f64>, hull: &Hull<f64>, options: &Options) -> Decision {
    let until = options.until.clamp(LEAST_UNTIL, 1.0);
    let free = free_until::<K, f64>(hull, options.separation.get(), until);
    if free < until {
        decide_after::<K>(points, hull, options.separation, [free, until])
    } else {
        Decision::Free(Stage::Advancement)
    }
}

/// The same for primitives that are known to be beyond d before the first of two times. A collision after the
/// second time, which is above 0, may be left out.
///
/// Few candidates get here. It is a function of its own, so that the stages above stay small.
#[inline(never)]
pub(super) fn decide_after<K: Tables>(
    points: &Points<f64>,
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
    let is_crossed = scaled.d > LEAST_CROSSED;
    let crossing =
        || is_crossed.then(|| Crossings::new::<K>(points, &scaled).first_between::<K>([free, until]))?;
    let beside_contact = || beside_contact::first_after::<K>(points, hull, &scaled, d.get(), free).map(Some);
    let is_free = || !is_crossed && Advancement::of(&scaled).free_after::<K>(free, until) == until;
    let first = crossing().or_else(beside_contact);
    match first.or_else(|| is_free().then_some(None)) {
        Some(Some(first)) if first.is_start() => Decision::Collision(Proved::Within(first, Stage::Start)),
        Some(Some(first)) => Decision::Collision(Proved::Within(first, Stage::Crossing)),
        Some(None) => Decision::Free(Stage::Crossing),
        None => Decision::Unknown,
    }
}

/// All times within a separation above 0, given the first one, if they are certain.
#[inline(never)]
pub(crate) fn intervals<K: Tables>(
    points: &Points<f64>,
    d: Separation,
    first: ContactTime,
) -> Option<Intervals> {
    let scaled = Scaled::new(&Hull::new::<K>(points), d.get())?;
    (scaled.d > LEAST_CROSSED).then(|| Crossings::new::<K>(points, &scaled).intervals::<K>(first))?
}

/// The closest points at the first time within a separation above 0, if they are certain.
#[inline(never)]
pub(crate) fn impact<K: Tables>(points: &Points<f64>, d: Separation, first: ContactTime) -> Option<Impact> {
    let scaled = Scaled::new(&Hull::new::<K>(points), d.get())?;
    Crossings::new::<K>(points, &scaled)
        .approach::<K>(first)?
        .impact::<K>(first)
}

/// Returns true if |x| < d for x = F(0, u, v) at a guess of the closest points.
fn starts_within<K: Tables>(scaled: &Scaled) -> bool {
    let [corners, _] = &scaled.at;
    let x = Closest::guess::<K>(corners).point(corners);
    is_certainly_within(x, scaled.d)
}

/// Returns true if |x| < d for x = F(t, u, v).
///
/// A component of x is off by at most 39 u (`proof/point.g`): corners result from their start, rounded once,
/// and from a velocity, or are at t = 0. So nothing is within a d below 2⁻⁴⁷; only such a d may be rounded.
fn is_certainly_within(x: Point, d: f64) -> bool {
    largest_square(x) < d * d
}

/// A bound of |x|² for [`is_certainly_within`], less one rounding.
///
/// A component and its error have one rounding, the square of the sum three, the two sums and the product
/// with the bound one each: six. The square of d has a seventh. The errors are relative to positive terms.
#[inline(always)]
fn largest_square<T: Lanes>([x, y, z]: [T; 3]) -> T {
    const ERROR: f64 = margin(39) * UNIT;
    let reach = [x.abs() + ERROR, y.abs() + ERROR, z.abs() + ERROR];
    dot(reach, reach) * (1.0 + margin(7) * UNIT)
}
