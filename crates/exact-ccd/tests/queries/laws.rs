//! What holds for the answers to every query, wherever it comes from.

use exact_ccd::{ContactTime, ContactTimes, Kind, Query, exact};

use crate::primitives::Points;

/// The query of these points, which are finite.
pub(crate) fn query<K: Kind>(points: &Points) -> Query<K> {
    Query::new(points[0], points[1]).unwrap()
}

/// The contact times, checked to be sound in themselves, the same as those of the exact path bit for bit, and in
/// accord with the other answers.
pub(crate) fn checked_times<K: Kind>(query: &Query<K>) -> ContactTimes {
    let times = query.contact_times();
    assert_eq!(bits(&times), bits(&exact::contact_times(query)), "{query:?}");
    assert_sound(&times);
    let touches = times.first().is_some();
    assert_eq!(query.collides(), touches, "{query:?}");
    assert_eq!(exact::collides(query), touches, "exactly: {query:?}");
    let first = times.first().map(|time| time.lower().to_bits());
    assert_eq!(query.time_of_impact().map(f64::to_bits), first, "{query:?}");
    times
}

/// All that can be told of contact times: whether they are finitely many, and their exact bits.
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
    assert_eq!(times.first(), all.first().copied());
    match times {
        ContactTimes::Finite(_) => assert_eq!(times.count(), Some(all.len())),
        ContactTimes::Interval { first } => {
            assert_eq!(times.count(), None);
            assert!(first.upper() <= 1.0 && first.lower() < 1.0, "{times:?}");
        }
    }
    for time in &all {
        assert!(
            time.lower() >= 0.0 && time.lower().is_sign_positive(),
            "{times:?}"
        );
        assert!(time.upper() <= 1.0, "{times:?}");
        let next = if time.is_exact() {
            time.lower()
        } else {
            time.lower().next_up()
        };
        assert_eq!(time.upper(), next);
    }
    for pair in all.windows(2) {
        // Two times that are no f64 may lie in one gap.
        let apart = pair[0].upper() <= pair[1].lower() && pair[0] != pair[1];
        let in_one_gap = pair[0] == pair[1] && !pair[0].is_exact();
        assert!(apart || in_one_gap, "{times:?}");
    }
}
