//! Contacts of a step.

use std::cmp::Ordering;

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

    /// The order of contacts.
    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        let key = |contact: &Self| (contact.impact.time, contact.pair);
        key(self).cmp(&key(other))
    }
}

/// The earlier of two contacts.
pub(crate) fn earlier(
    a: Option<(ContactTime, Pair)>,
    b: Option<(ContactTime, Pair)>,
) -> Option<(ContactTime, Pair)> {
    a.into_iter().chain(b).min()
}
