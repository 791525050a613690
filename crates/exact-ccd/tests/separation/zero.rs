//! Primitives are within the distance 0 if and only if they are in contact.

use exact_ccd::separation::{Separation, TimeInterval};
use exact_ccd::{ContactTime, ContactTimes, exact};

use crate::families::{cases, extreme, ordinary};
use crate::kinds::{FromFour, for_each_kind};
use crate::laws::{bits, checked_intervals, time_bits};
use crate::primitives::Points;
use crate::runner::for_all;

fn is_contact<K: FromFour>(points: &Points) {
    let query = K::query(points);
    let zero = Separation::default();
    let intervals = checked_intervals(&query, zero);
    match exact::contact_times(&query) {
        ContactTimes::Finite(times) => {
            let moment = |&time: &ContactTime| TimeInterval {
                start: time,
                end: time,
            };
            let moments: Vec<_> = times.iter().map(moment).collect();
            assert_eq!(bits(&intervals), bits(&moments), "{query:?}");
        }
        ContactTimes::Interval { first } => {
            assert_eq!(time_bits(intervals[0].start), time_bits(first), "{query:?}");
            // Both ends of a short interval may lie between the same two adjacent f64.
            let may_last =
                |interval: &TimeInterval| interval.start != interval.end || !interval.start.is_exact();
            assert!(intervals.iter().any(may_last), "{query:?}");
        }
    }
    assert_eq!(query.comes_within(zero), query.collides());
    assert_eq!(query.time_within(zero), query.time_of_impact());
    assert_eq!(query.impact_within(zero), query.impact());
}

fn contact_on_ordinary_points<K: FromFour>() {
    for_all(cases(6_000), ordinary(), |points| is_contact::<K>(&points));
}

fn contact_on_extreme_points<K: FromFour>() {
    for_all(cases(400), extreme(), |points| is_contact::<K>(&points));
}

for_each_kind! {
    is_contact_on_ordinary_points => contact_on_ordinary_points;
    is_contact_on_extreme_points => contact_on_extreme_points;
}
