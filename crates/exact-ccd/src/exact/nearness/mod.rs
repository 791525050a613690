//! The definition for a separation d above 0: the distance of the primitives compared with d, in integers.
//!
//! The squared distance of the primitives is the least one of their features (`feature.rs`), each a
//! quotient of polynomials in t. The times at which the distance is at most d form closed
//! intervals, which begin and end at 0, at 1, or at roots of the features' excesses over d². The
//! proofs are in `docs/separation.md`.

mod closest;
mod distance;
mod feature;
mod first_within;
mod scaled;

#[cfg(test)]
use alloc::vec::Vec;

pub(crate) use distance::distance_at;
pub(crate) use first_within::FirstWithin;

use super::instant::Instant;
use super::narrowing::Narrowing;
use super::points::MovingPoints;
#[cfg(test)]
use super::polynomial::Polynomial;
use super::split::Split;
use crate::tables::Tables;
use crate::values::Separation;
use feature::Feature;
use scaled::Scaled;

/// The first and the last time.
static STEP: [Split; 2] = [Split::START, Split::END];

/// Returns true if the primitives come within d.
pub(super) fn comes_within<K: Tables>(points: &MovingPoints, d: Separation) -> bool {
    let features = Scaled::new(points, d).features::<K>();
    STEP.iter().any(|t| is_within_at(&features, t)) || features.iter().any(Feature::crosses)
}

/// Returns true if the distance is at most d at a time.
fn is_within_at(features: &[Feature], t: &Split) -> bool {
    let instant = &Narrowing::new(Instant::At(t.clone()));
    features.iter().any(|feature| feature.is_within(instant))
}

/// The degrees of the excesses of all pairs of features.
#[cfg(test)]
pub(super) fn excess_degrees<K: Tables>(
    points: &MovingPoints,
    d: Separation,
    degree: impl Fn(&Polynomial) -> usize,
) -> Vec<usize> {
    let features = Scaled::new(points, d).features::<K>();
    features.iter().map(|feature| degree(feature.excess())).collect()
}
