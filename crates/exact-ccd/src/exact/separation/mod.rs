//! The definition of separation: the distance of the primitives compared with d, in integers.
//!
//! The squared distance of the primitives is the least of those of their features (`feature.rs`),
//! each a quotient of polynomials in t. The times at which the distance is at most d form closed
//! intervals, which begin and end at 0, at 1, or at roots of the features' excesses over d². The
//! proofs are in `docs/separation.md`.

mod approach;
mod closest;
mod distance;
mod feature;

use alloc::vec::Vec;

use super::instant::Instant;
use super::narrowing::Narrowing;
use super::split::Split;
use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::separation::{DistanceBounds, Separation, TimeInterval, TimeOutOfStep};
use crate::time::ContactTime;
use approach::Approach;
use feature::Feature;

/// The first and the last time.
static STEP: [Split; 2] = [Split::START, Split::END];

/// [`Query::comes_within`], decided in integers alone.
#[must_use]
pub fn comes_within<K: Kind>(query: &Query<K>, d: Separation) -> bool {
    let features = Approach::new(query, d).features::<K>();
    is_within_at(&features, &STEP[0]) || first_crossings(&features, &STEP).next().is_some()
}

/// [`Query::first_within`], computed in integers alone.
#[must_use]
pub fn first_within<K: Kind>(query: &Query<K>, d: Separation) -> Option<ContactTime> {
    let features = Approach::new(query, d).features::<K>();
    if is_within_at(&features, &STEP[0]) {
        return Some(ContactTime::exactly(0.0));
    }
    // Rounding is monotone: the least of the rounded times is the least time, rounded.
    let times = first_crossings(&features, &STEP).map(|instant| instant.round());
    times.reduce(|a, b| if b < a { b } else { a })
}

/// [`Query::intervals_within`], computed in integers alone.
#[must_use]
pub fn intervals_within<K: Kind>(query: &Query<K>, d: Separation) -> Vec<TimeInterval> {
    let features = Approach::new(query, d).features::<K>();
    let mut events = Vec::new();
    for feature in &features {
        for event in feature.crossings(&STEP) {
            event.insert_into(&mut events);
        }
    }
    for end in STEP.iter().filter(|end| is_within_at(&features, end)) {
        Instant::At(end.clone()).insert_into(&mut events);
    }
    // The distance is at most d at each of them, and nothing changes between two.
    let mut intervals = Vec::new();
    let mut start = None;
    for (i, event) in events.iter().enumerate() {
        let first = *start.get_or_insert(event);
        let continues = |next: &Instant| is_within_at(&features, &event.before(next));
        if !events.get(i + 1).is_some_and(continues) {
            intervals.push(TimeInterval {
                start: first.round(),
                end: event.round(),
            });
            start = None;
        }
    }
    intervals
}

/// [`Query::impact_within`] for d > 0, computed in integers alone.
#[must_use]
pub fn impact_within<K: Kind>(query: &Query<K>, d: Separation) -> Option<Impact> {
    let approach = Approach::new(query, d);
    let features = approach.features::<K>();
    let first = first_instant(&features, &STEP)?;
    closest::impact::<K>(&approach, &features, &first)
}

/// [`impact_within`] for d > 0, given the first time.
pub(crate) fn impact_at<K: Kind>(query: &Query<K>, d: Separation, first: ContactTime) -> Option<Impact> {
    let approach = Approach::new(query, d);
    let features = approach.features::<K>();
    let first = instant_at(&features, first)?;
    closest::impact::<K>(&approach, &features, &first)
}

/// [`Query::distance_at`], computed in integers alone.
///
/// # Errors
/// [`TimeOutOfStep`], if `t` is not in [0, 1].
pub fn distance_at<K: Kind>(query: &Query<K>, t: f64) -> Result<DistanceBounds, TimeOutOfStep> {
    TimeOutOfStep::check(t)?;
    Ok(distance::bounds(query, t))
}

/// The first time in [low, high] at which the distance is at most d, if there is one.
fn first_instant(features: &[Feature], bounds: &[Split; 2]) -> Option<Instant> {
    if is_within_at(features, &bounds[0]) {
        return Some(Instant::At(bounds[0].clone()));
    }
    let mut times = Vec::new();
    for time in first_crossings(features, bounds) {
        time.insert_into(&mut times);
    }
    times.into_iter().next()
}

/// The first instant within d, given its time: an f64, or a root of some excess between two of them.
fn instant_at(features: &[Feature], time: ContactTime) -> Option<Instant> {
    let bounds = [time.lower(), time.upper()].map(Split::from_unit);
    if time.is_exact() {
        return Some(Instant::At(bounds[0].clone()));
    }
    let [[low, _], [_, high]] = [bounds[0].neighbours(), bounds[1].neighbours()];
    first_instant(features, &[low, high])
}

/// Times within d, among which is the first in [low, high] if it is not `low`: the first crossing of
/// each feature, and `high`.
fn first_crossings(features: &[Feature], bounds: &[Split; 2]) -> impl Iterator<Item = Instant> {
    let end = is_within_at(features, &bounds[1]).then(|| Instant::At(bounds[1].clone()));
    let crossings = features
        .iter()
        .filter_map(|feature| feature.crossings(bounds).next());
    end.into_iter().chain(crossings)
}

/// True if the distance is at most d at a time.
fn is_within_at(features: &[Feature], t: &Split) -> bool {
    let instant = &Narrowing::new(&Instant::At(t.clone()));
    features.iter().any(|feature| feature.is_within(instant))
}
