//! Intervals of contact between events.

use alloc::vec::Vec;

use super::instant::Instant;
use super::split::Split;
use crate::interval::{Interval, Intervals};

/// A time of contact at which contact may begin or end.
#[derive(Clone, Debug)]
pub(super) struct Event {
    pub(super) time: Instant,
    pub(super) passage: Passage,
}

/// The contact next to an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Passage {
    /// The primitives touch just after it.
    Entry,
    /// They touch just before it.
    Exit,
    /// Neither is known.
    Unknown,
}

/// The maximal intervals of contact, given events in any order, among which are all times at which contact
/// begins or ends, and the decision at any time between two of them.
pub(super) fn intervals_of(events: Vec<Event>, touches: impl Fn(&Split) -> bool) -> Intervals {
    let places = places(events);
    let mut start = 0;
    let close = |end: usize| {
        let [first, last] = [start, end].map(|index| places[index].iter().map(|event| event.time.round()));
        let interval = Interval {
            start: first.min()?,
            end: last.max()?,
            is_moment: start == end,
        };
        start = end + 1;
        Some(interval)
    };
    let ends = (0..places.len()).filter(|&i| {
        let next = places.get(i + 1);
        !next.is_some_and(|next| is_joined(&places[i], next, &touches))
    });
    ends.filter_map(close).collect()
}

/// Events in increasing order, each with those that are not told apart from it.
///
/// Entries without another event between them are in one interval, because nothing changes between them. So
/// are exits. Their order does not matter: the least time is one of those with the least rounded value. Other
/// events are told apart, and of equal ones, one remains.
fn places(events: Vec<Event>) -> Vec<Vec<Event>> {
    let mut distinct: Vec<Event> = Vec::new();
    for mut event in events {
        let is_equal = |other: &mut Event| !event.is_like(other) && event.time.order(&mut other.time).is_eq();
        if !distinct.iter_mut().any(is_equal) {
            distinct.push(event);
        }
    }
    distinct.sort_by(|one, other| one.bounds()[0].cmp(other.bounds()[0]));
    let mut places: Vec<Vec<Event>> = Vec::new();
    for event in distinct {
        // The brackets of events that are told apart are disjoint.
        let is_apart = |other: &Event| other.bounds()[1] < event.bounds()[0];
        match places.last_mut() {
            Some(place) if !place.iter().all(is_apart) => place.push(event),
            _ => places.push([event].into()),
        }
    }
    places
}

impl Event {
    /// Returns true for two entries or two exits.
    fn is_like(&self, other: &Self) -> bool {
        self.passage == other.passage && self.passage != Passage::Unknown
    }

    fn bounds(&self) -> [&Split; 2] {
        self.time.bounds().into()
    }
}

/// Returns true if there is contact at all times between a place and the next one.
fn is_joined(place: &[Event], next: &[Event], touches: impl Fn(&Split) -> bool) -> bool {
    let is = |place: &[Event], passage| place.iter().any(|event| event.passage == passage);
    let high = place.iter().map(|event| event.bounds()[1]).max();
    let low = next.iter().map(|event| event.bounds()[0]).min();
    is(place, Passage::Entry)
        || is(next, Passage::Exit)
        || high
            .zip(low)
            .is_some_and(|(high, low)| touches(&Split::between(high, low)))
}
