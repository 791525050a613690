//! With a larger distance, the first time is not later, and the intervals contain the intervals of the
//! smaller distance.

use exact_ccd::{Interval, Kind};

use crate::queries::each_kind::for_each_kind;
use crate::queries::families::{cases, ordinary, rule};
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::runner::for_all;

fn grows<K: Kind>() {
    for_all(
        cases(20_000),
        (ordinary(), rule(), rule()),
        |(points, one, other)| {
            let query = query::<K>(&points);
            let [one, other] = [one, other].map(|rule| rule.separation::<K>(&points));
            let (less, more) = if one < other { (one, other) } else { (other, one) };
            let (short, long) = (query.intervals(less), query.intervals(more));
            let is_covered =
                |inner: &Interval| long.iter().any(|o| o.start <= inner.start && inner.end <= o.end);
            assert!(short.iter().all(is_covered), "{less:?} and {more:?}: {query:?}");
            assert!(
                !query.collides(less) || query.collides(more),
                "{less:?} and {more:?}: {query:?}"
            );
        },
    );
}

for_each_kind! {
    intervals_grow_with_the_distance => grows;
}
