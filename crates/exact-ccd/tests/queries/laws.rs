//! Properties of the answers to every query.

use std::cmp::Ordering;

use exact_ccd::{ContactTime, ContactTimes, Kind, Point, Query, exact};

use crate::primitives::{Points, Primitives};
use crate::symmetry::Symmetry;

/// The query of these points, which are finite.
pub(crate) fn query<K: Kind<Points = [Point; 4]>>(points: &Points) -> Query<K> {
    Query::new(points[0], points[1]).unwrap()
}

/// The contact times, checked: they are increasing times in [0, 1], the same as those of the exact
/// path bit for bit, and consistent with the other answers, which are computed apart from them.
pub(crate) fn checked_times<K: Kind>(query: &Query<K>) -> ContactTimes {
    let times = query.contact_times();
    assert_eq!(bits(&times), bits(&exact::contact_times(query)), "{query:?}");
    assert_sound(&times);
    let touches = times.first().is_some();
    assert_eq!(query.collides(), touches, "{query:?}");
    assert_eq!(exact::collides(query), touches, "exactly: {query:?}");
    // The time of impact and the impact are computed without the later times.
    let first = times.first();
    let lower = first.map(|time| time.lower().to_bits());
    assert_eq!(query.time_of_impact().map(f64::to_bits), lower, "{query:?}");
    assert_eq!(query.impact().map(|impact| impact.time), first, "{query:?}");
    times
}

/// The bits of contact times, and true if they are finitely many.
pub(crate) fn bits(times: &ContactTimes) -> (bool, Vec<(u64, bool)>) {
    let bits = |time: &ContactTime| (time.lower().to_bits(), time.is_exact());
    match times {
        ContactTimes::Finite(times) => (true, times.iter().map(bits).collect()),
        ContactTimes::Interval { first } => (false, vec![bits(first)]),
    }
}

fn assert_sound(times: &ContactTimes) {
    let all: Vec<ContactTime> = match times {
        ContactTimes::Finite(times) => times.to_vec(),
        ContactTimes::Interval { first } => vec![*first],
    };
    if let ContactTimes::Interval { first } = times {
        assert!(first.lower() < 1.0, "{times:?}");
    }
    for time in &all {
        assert!(
            time.lower() >= 0.0 && time.lower().is_sign_positive(),
            "{times:?}"
        );
        assert!(time.upper() <= 1.0, "{times:?}");
    }
    for pair in all.windows(2) {
        // Two times that are not f64 may lie between the same two f64.
        let apart = pair[0].upper() <= pair[1].lower() && pair[0] != pair[1];
        let in_one_gap = pair[0] == pair[1] && !pair[0].is_exact();
        assert!(apart || in_one_gap, "{times:?}");
    }
}

/// Checks that a symmetry does not change the contact times.
pub(crate) fn assert_symmetric<K: Primitives>(points: &Points, symmetry: &Symmetry) {
    let image = symmetry.apply::<K>(points);
    assert_same_times(&query::<K>(points), &query::<K>(&image));
}

pub(crate) fn assert_same_times<K: Kind, L: Kind>(one: &Query<K>, other: &Query<L>) {
    let (times, others) = (one.contact_times(), other.contact_times());
    assert_eq!(bits(&times), bits(&others), "{one:?} and {other:?}");
    assert_eq!(one.collides(), other.collides(), "{one:?} and {other:?}");
}

/// Checks that a contact at t is one at 1 − t when time runs backwards.
pub(crate) fn assert_reversible<K: Primitives>(points: &Points) {
    let [start, end] = *points;
    let (forth, back) = (query::<K>(points), query::<K>(&[end, start]));
    assert_eq!(forth.collides(), back.collides(), "{forth:?}");
    let (times, reversed) = (forth.contact_times(), back.contact_times());
    match (&times, &reversed) {
        (ContactTimes::Finite(times), ContactTimes::Finite(reversed)) => {
            assert_eq!(times.len(), reversed.len(), "{forth:?}");
            for (a, b) in times.iter().zip(reversed.iter().rev()) {
                assert!(may_add_up_to_one(*a, *b), "{a:?} and {b:?}: {forth:?}");
            }
        }
        (ContactTimes::Interval { first }, ContactTimes::Interval { first: last }) => {
            let sum = compare_sum_with_one(first.lower(), last.lower());
            assert!(sum.is_lt(), "from {first:?} to 1 − {last:?}: {forth:?}");
        }
        _ => panic!("{times:?}, backwards {reversed:?}: {forth:?}"),
    }
}

/// Returns true if the times may be t and 1 − t.
fn may_add_up_to_one(a: ContactTime, b: ContactTime) -> bool {
    let lower = compare_sum_with_one(a.lower(), b.lower());
    let upper = compare_sum_with_one(a.upper(), b.upper());
    if a.is_exact() && b.is_exact() {
        lower.is_eq()
    } else {
        lower.is_lt() && upper.is_gt()
    }
}

/// The comparison of a + b with 1, for numbers in [0, 1]. It is exact, because 1 − x is for x ≥ 1/2.
fn compare_sum_with_one(a: f64, b: f64) -> Ordering {
    let (smaller, larger) = if a < b { (a, b) } else { (b, a) };
    if larger < 0.5 {
        Ordering::Less
    } else {
        smaller.total_cmp(&(1.0 - larger))
    }
}
