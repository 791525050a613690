//! Intervals of contact between events.

use alloc::vec::Vec;

use super::instant::Instant;
use super::split::Split;
use crate::values::{Interval, Intervals};

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

#[cfg(test)]
mod tests {
    use alloc::vec;
    use core::cmp::Ordering;

    use dashu_int::IBig;
    use fastrand::Rng;

    use super::*;
    use crate::exact::polynomial::Polynomial;
    use crate::exact::roots::roots_of;

    /// The time at which the ratio of the time elapsed to the time left has this square.
    fn root_of(square: [u64; 2]) -> Instant {
        let [numerator, denominator] = square.map(IBig::from);
        let polynomial = Polynomial::new(vec![-numerator, IBig::ZERO, denominator]);
        let mut roots = roots_of(&polynomial);
        roots.pop().expect("there is one")
    }

    /// The union of intervals, with ends that are often equal or next to each other, does not depend on what
    /// is known of its events, on their brackets and on their order.
    #[test]
    fn entries_and_exits_are_the_ends_of_unions() {
        let mut random = Rng::with_seed(0);
        let (mut all, mut moments) = (0, 0);
        for _ in 0..2000 {
            let mut square = || {
                let denominator = 1 << [1, 2, 40][random.usize(..3)];
                let beside = [0, 1, 1 << 6, 1 << 12, 1 << 20][random.usize(..5)].min(denominator / 2);
                [random.u64(1..6) * denominator + beside, denominator]
            };
            let less = |a: [u64; 2], b: [u64; 2]| {
                u128::from(a[0]) * u128::from(b[1]) < u128::from(b[0]) * u128::from(a[1])
            };
            let ends = [(); 4].map(|()| [square(), square()]);
            let ends = ends.map(|[a, b]| if less(b, a) { [b, a] } else { [a, b] });
            let ends = &ends[..random.usize(1..5)];
            let times = ends.iter().map(|ends| ends.map(root_of)).collect::<Vec<_>>();
            let touches = |t: &Split| {
                let contains =
                    |[start, end]: &[Instant; 2]| start.compare(t).is_le() && end.compare(t).is_ge();
                times.iter().any(contains)
            };
            let mut events = |is_known: bool| {
                let mut events: Vec<Event> = Vec::new();
                for (ends, times) in ends.iter().zip(&times) {
                    let is_known = is_known && less(ends[0], ends[1]);
                    let passages = [Passage::Entry, Passage::Exit];
                    for (mut time, passage) in times.iter().cloned().zip(passages) {
                        time.narrow_to(random.usize(..70));
                        let passage = if is_known { passage } else { Passage::Unknown };
                        events.push(Event { time, passage });
                    }
                }
                random.shuffle(&mut events);
                events
            };
            let expected = intervals_of(events(false), touches);
            assert_eq!(intervals_of(events(true), touches), expected, "{ends:?}");
            all += expected.len();
            moments += expected.iter().filter(|interval| interval.is_moment).count();
            let first = times
                .iter()
                .map(|[start, _]| start.clone())
                .reduce(Instant::earlier);
            let start = first.map(|first| first.round());
            assert_eq!(
                start.map(|start| start.cmp(&expected[0].start)),
                Some(Ordering::Equal)
            );
        }
        assert!(all > 2000 && moments > 50, "{all} {moments}");
    }
}
