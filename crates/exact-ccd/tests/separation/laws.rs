//! Laws of the answers to every query.

use exact_ccd::separation::{Separation, TimeInterval};
use exact_ccd::{ContactTime, Kind, Query, exact};

/// The times within d. They are checked to be ordered times of the step, bit for bit those of the
/// exact path, and consistent with the other answers.
pub(crate) fn checked_intervals<K: Kind>(query: &Query<K>, d: Separation) -> Vec<TimeInterval> {
    let intervals = query.intervals_within(d);
    assert_eq!(
        bits(&intervals),
        bits(&exact::separation::intervals_within(query, d)),
        "{d:?}: {query:?}"
    );
    assert_sound(&intervals);
    let first = intervals.first().map(|interval| interval.start);
    assert_eq!(
        first_bits(query.first_within(d)),
        first_bits(first),
        "{d:?}: {query:?}"
    );
    assert_eq!(
        first_bits(exact::separation::first_within(query, d)),
        first_bits(first),
        "exactly, {d:?}: {query:?}"
    );
    assert_eq!(
        query.time_within(d),
        first.map(ContactTime::lower),
        "{d:?}: {query:?}"
    );
    assert_eq!(query.comes_within(d), first.is_some(), "{d:?}: {query:?}");
    assert_eq!(
        exact::separation::comes_within(query, d),
        first.is_some(),
        "exactly, {d:?}: {query:?}"
    );
    intervals
}

pub(crate) type Bits = (u64, bool);

pub(crate) fn time_bits(time: ContactTime) -> Bits {
    (time.lower().to_bits(), time.is_exact())
}

fn first_bits(first: Option<ContactTime>) -> Option<Bits> {
    first.map(time_bits)
}

pub(crate) fn bits(intervals: &[TimeInterval]) -> Vec<[Bits; 2]> {
    let both = |interval: &TimeInterval| [time_bits(interval.start), time_bits(interval.end)];
    intervals.iter().map(both).collect()
}

fn assert_sound(intervals: &[TimeInterval]) {
    for TimeInterval { start, end } in intervals {
        assert!(
            start.lower() >= 0.0 && start.lower().is_sign_positive(),
            "{intervals:?}"
        );
        assert!(start <= end && end.upper() <= 1.0, "{intervals:?}");
    }
    for pair in intervals.windows(2) {
        let (end, start) = (pair[0].end, pair[1].start);
        // Two times that are not f64 may lie between the same two f64.
        assert!(end < start || (end == start && !end.is_exact()), "{intervals:?}");
    }
}

/// True if t is in one of the intervals.
pub(crate) fn contain(intervals: &[TimeInterval], t: f64) -> bool {
    intervals
        .iter()
        .any(|interval| interval.start.upper() <= t && t <= interval.end.lower())
}
