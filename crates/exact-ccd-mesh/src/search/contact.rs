//! Contacts of a step.

use exact_ccd::{Collision, ContactTime, DistanceBounds, Impact, Kind};

use crate::pairs::Pair;

/// A pair of primitives that touch in a step, and the first time at which they do.
///
/// Contacts are in the order of their times. Among contacts whose times lie between the same two
/// adjacent f64, or are the same f64, the lesser [`Pair`] comes first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The pair.
    pub pair: Pair,
    /// The time and the place of its first contact.
    pub impact: Impact,
    /// Bounds of the distance of the primitives at that time: 0 or the minimum distance of the pair; less if
    /// the pair starts nearer.
    pub distance: DistanceBounds,
}

impl Contact {
    /// The contact of a pair.
    pub(crate) fn new<K: Kind>(pair: Pair, collision: &Collision<'_, K>) -> Self {
        Self {
            pair,
            impact: collision.impact(),
            distance: collision.distance(),
        }
    }

    /// Contacts are in the order of their keys.
    pub(crate) fn key(&self) -> (ContactTime, Pair) {
        (self.impact.time, self.pair)
    }
}
