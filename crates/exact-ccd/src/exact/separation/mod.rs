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

use alloc::vec;
use alloc::vec::Vec;

use super::dyadic::Dyadic;
use super::instant::{Instant, roots, roots_between};
use super::narrowing::Narrowing;
use super::polynomial::Polynomial;
use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::separation::{DistanceBounds, Separation, TimeInterval, TimeOutOfStep};
use crate::time::ContactTime;
use approach::Approach;
use feature::Feature;

/// [`Query::comes_within`], decided in integers alone.
#[must_use]
pub fn comes_within<K: Kind>(query: &Query<K>, d: Separation) -> bool {
    let features = Approach::new(query, d).features::<K>();
    is_within(&features, &Instant::Dyadic(Dyadic::ZERO)) || crossings(&features).next().is_some()
}

/// [`Query::first_within`], computed in integers alone.
#[must_use]
pub fn first_within<K: Kind>(query: &Query<K>, d: Separation) -> Option<ContactTime> {
    let features = Approach::new(query, d).features::<K>();
    if is_within(&features, &Instant::Dyadic(Dyadic::ZERO)) {
        return Some(ContactTime::exactly(0.0));
    }
    // Rounding is monotone: the least of the rounded times is the least time, rounded.
    crossings(&features).map(|instant| instant.round()).min()
}

/// [`Query::intervals_within`], computed in integers alone.
#[must_use]
pub fn intervals_within<K: Kind>(query: &Query<K>, d: Separation) -> Vec<TimeInterval> {
    let features = Approach::new(query, d).features::<K>();
    let events = roots(events(&features));
    let mut intervals = Vec::new();
    let mut start = None;
    for (i, event) in events.iter().enumerate() {
        // Within d just before an event is within d at it: the distance is continuous.
        if start.is_none() && is_within(&features, event) {
            start = Some(event);
        }
        let continues = |next: &Instant| is_within(&features, &Instant::Dyadic(event.before(next)));
        if start.is_some() && !events.get(i + 1).is_some_and(continues) {
            intervals.extend(start.take().map(|start| TimeInterval {
                start: start.round(),
                end: event.round(),
            }));
        }
    }
    intervals
}

/// [`Query::impact_within`] for d > 0, computed in integers alone.
#[must_use]
pub fn impact_within<K: Kind>(query: &Query<K>, d: Separation) -> Option<Impact> {
    let approach = Approach::new(query, d);
    let features = approach.features::<K>();
    let first = first_instant(&features)?;
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
    Ok(distance::bounds(query, &Dyadic::from_unit(t)))
}

/// The first time at which the distance is at most d, if there is one.
fn first_instant(features: &[Feature]) -> Option<Instant> {
    let start = Instant::Dyadic(Dyadic::ZERO);
    if is_within(features, &start) {
        return Some(start);
    }
    roots(events(features))
        .into_iter()
        .find(|event| is_within(features, event))
}

/// The first instant within d, given its time: an f64, or a root of some excess between two of them.
fn instant_at(features: &[Feature], time: ContactTime) -> Option<Instant> {
    let [low, high] = [time.lower(), time.upper()].map(Dyadic::from_unit);
    if time.is_exact() {
        return Some(Instant::Dyadic(low));
    }
    let changing = features
        .iter()
        .map(Feature::excess)
        .filter(|excess| excess.sign_between(&low, &high).is_none());
    roots_between(changing.cloned().collect(), &low, &high)
        .into_iter()
        .find(|event| is_within(features, event))
}

/// Times within d, among which is the first if it is not 0: roots of single excesses, and t = 1.
fn crossings(features: &[Feature]) -> impl Iterator<Item = Instant> {
    let of_feature = |feature: &Feature| {
        let roots = roots(vec![feature.excess().clone()]);
        roots.into_iter().find(|root| is_within(features, root))
    };
    let inside = features
        .iter()
        .filter(|feature| feature.may_cross())
        .filter_map(of_feature);
    let end = Some(Instant::Dyadic(Dyadic::ONE)).filter(|end| is_within(features, end));
    inside.chain(end)
}

/// True if the distance is at most d at an instant.
fn is_within(features: &[Feature], instant: &Instant) -> bool {
    let instant = &Narrowing::new(instant);
    features.iter().any(|feature| feature.is_within(instant))
}

/// Polynomials, not zero, among whose roots are all times at which the primitives come within d or
/// leave, and the ends of the step.
fn events(features: &[Feature]) -> Vec<Polynomial> {
    let crossing = features.iter().filter(|feature| feature.may_cross());
    let excesses = crossing.map(|feature| feature.excess().clone());
    [Polynomial::ends()].into_iter().chain(excesses).collect()
}
