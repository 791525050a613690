//! With a larger distance, the first time is not later, and the intervals contain those of the
//! smaller distance.

use exact_ccd::separation::TimeInterval;

use crate::families::{cases, ordinary, rule};
use crate::kinds::{FromFour, for_each_kind};
use crate::runner::for_all;

fn grows<K: FromFour>() {
    for_all(
        cases(20_000),
        (ordinary(), rule(), rule()),
        |(points, one, other)| {
            let query = K::query(&points);
            let [one, other] = [one, other].map(|rule| rule.separation::<K>(&points));
            let (less, more) = if one < other { (one, other) } else { (other, one) };
            let (short, long) = (query.intervals_within(less), query.intervals_within(more));
            let is_covered =
                |inner: &TimeInterval| long.iter().any(|o| o.start <= inner.start && inner.end <= o.end);
            assert!(short.iter().all(is_covered), "{less:?} and {more:?}: {query:?}");
            assert!(
                !query.comes_within(less) || query.comes_within(more),
                "{less:?} and {more:?}: {query:?}"
            );
        },
    );
}

for_each_kind! {
    intervals_grow_with_the_distance => grows;
}
