//! The definition for a separation d above 0: the distance of the primitives compared with d, in integers.
//!
//! The squared distance of the primitives is the least of those of their features (`feature.rs`),
//! each a quotient of polynomials in t. The times at which the distance is at most d form closed
//! intervals, which begin and end at 0, at 1, or at roots of the features' excesses over d². The
//! proofs are in `docs/separation.md`.

mod approach;
mod closest;
mod distance;
mod feature;
mod first_within;

pub(crate) use first_within::{FirstWithin, intervals_within};

use super::instant::Instant;
use super::narrowing::Narrowing;
use super::split::Split;
use crate::distance::{DistanceBounds, Separation, TimeOutOfStep};
use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::time::ContactTime;
use approach::Approach;
use feature::Feature;

/// The first and the last time.
static STEP: [Split; 2] = [Split::START, Split::END];

/// Returns true if the primitives come within d.
pub(super) fn comes_within<K: Kind>(query: &Query<K>, d: Separation) -> bool {
    let features = Approach::new(query, d).features::<K>();
    is_within_at(&features, &STEP[0]) || first_crossings(&features, &STEP).next().is_some()
}

/// The closest points at the first time at which the primitives are within d, given that time.
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
    first_crossings(features, bounds).reduce(Instant::earlier)
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

/// Returns true if the distance is at most d at a time.
fn is_within_at(features: &[Feature], t: &Split) -> bool {
    let instant = &Narrowing::new(Instant::At(t.clone()));
    features.iter().any(|feature| feature.is_within(instant))
}
