//! Intervals of contact between events.

use super::instant::Instant;
use super::split::Split;
use crate::interval::{Interval, Intervals};

/// The maximal intervals of contact, given distinct times of contact in increasing order, among which are all
/// at which contact begins or ends, and the decision at any time between two of them.
pub(super) fn intervals_of(events: &[Instant], touches: impl Fn(&Split) -> bool) -> Intervals {
    let mut start = 0;
    let close = |end: usize| {
        let interval = Interval {
            start: events[start].round(),
            end: events[end].round(),
            is_moment: start == end,
        };
        start = end + 1;
        interval
    };
    let ends = (0..events.len()).filter(|&i| {
        let next = events.get(i + 1);
        !next.is_some_and(|next| touches(&events[i].before(next)))
    });
    ends.map(close).collect()
}
