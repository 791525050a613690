//! Primitives that first touch after the last time that counts do not collide.

use exact_ccd::batch;
use exact_ccd::{Collision, ContactTime, Intervals, Kind, Options, Query, Separation};
use proptest::prelude::*;

use crate::queries::batch::{trajectories, values, vertices};
use crate::queries::each_kind::for_each_kind;
use crate::queries::families::{Rule, cases, extreme, ordinary, rule};
use crate::queries::named_cases::vertex_against;
use exact_ccd_testing::kinds::{points_of, query};
use exact_ccd_testing::primitives::Points;
use exact_ccd_testing::runner::for_all;

/// Last times: both ends of the step, beyond them, and the least number above 0.
const ENDS: [f64; 12] = [
    f64::NAN,
    f64::NEG_INFINITY,
    -1.0,
    -f64::from_bits(1),
    -0.0,
    0.0,
    f64::from_bits(1),
    0.5,
    1.0f64.next_down(),
    1.0,
    2.0,
    f64::INFINITY,
];

/// The numbers around a time.
fn around(time: ContactTime) -> [f64; 4] {
    let (lower, upper) = (time.lower(), time.upper());
    [lower.next_down(), lower, upper, upper.next_up()]
}

/// Each answer until a time equals the answer for the whole step, or is none, by the filters and in integers.
fn counts_until<K: Kind>(query: &Query<K>, d: Separation, whole: &Intervals, until: f64) {
    let first = whole.first_time();
    // False for NaN.
    let counts = first.is_some_and(|first| first.upper() <= until);
    assert_eq!(
        first.is_some_and(|first| first.is_at_most(until)),
        counts,
        "{first:?}, {until:e}"
    );
    let options = Options::within(d).until(until);
    let context = || format!("until {until:e}, {d:?}: {query:?}");
    let first = first.filter(|_| counts);
    let intervals = if counts {
        whole.clone()
    } else {
        Intervals::default()
    };

    let collision = query.collision(options);
    assert_eq!(collision.as_ref().map(Collision::time), first, "{}", context());
    assert_eq!(query.decide(options).0.is_some(), counts, "{}", context());
    if let Some((collision, first)) = collision.zip(first) {
        let is_before = first.lower() < until;
        assert_eq!(collision.is_before(until), is_before, "{}", context());
    }
    let decisions = [query.collides(options), query.exactly().collides(options)];
    assert_eq!(decisions, [counts; 2], "{}", context());
    let times = [
        query.time_of_impact(options),
        query.exactly().time_of_impact(options),
    ];
    assert_eq!(times, [first.map(ContactTime::lower); 2], "{}", context());
    assert_eq!(query.intervals(options), intervals, "{}", context());
    assert_eq!(query.exactly().intervals(options), intervals, "{}", context());
    let impacts = [query.impact(options), query.exactly().impact(options)];
    let times = impacts.map(|impact| impact.map(|impact| impact.time));
    assert_eq!(times, [first; 2], "{}", context());
    let of_whole = query.impact(d).filter(|_| counts);
    assert_eq!(impacts[0], of_whole, "{}", context());
}

fn single<K: Kind>(count: u32, points: impl Strategy<Value = Points>, rule: impl Strategy<Value = Rule>) {
    for_all(cases(count), (points, rule), |(points, rule)| {
        let query = query::<K>(&points);
        let d = rule.separation::<K>(&points);
        let whole = query.intervals(d);
        let times = whole.iter().flat_map(|interval| [interval.start, interval.end]);
        for until in ENDS.into_iter().chain(times.flat_map(around)) {
            counts_until(&query, d, &whole, until);
        }
    });
}

fn single_queries<K: Kind>() {
    let contact = || Just(Rule::Fixed(0.0));
    single::<K>(2_000, ordinary(), contact());
    single::<K>(200, extreme(), contact());
    single::<K>(2_000, ordinary(), rule());
    single::<K>(200, extreme(), rule());
}

fn batches<K: Kind>() {
    let points = values(cases(2_000), ordinary()).into_iter();
    let queries: Vec<[K::Points; 2]> = points.map(|ends| ends.map(points_of::<K>)).collect();
    let trajectories = trajectories(&queries);
    let vertices = vertices::<K>(queries.len());
    for d in [0.0, 0.25, 1.0].map(|d| Separation::new(d).unwrap()) {
        let first = |&[start, end]: &[K::Points; 2]| {
            let query = Query::<K>::new(start, end).unwrap();
            query.collision(d).map(|collision| collision.time())
        };
        let firsts: Vec<(usize, ContactTime)> = (0..)
            .zip(queries.iter().map(first))
            .filter_map(|(index, first)| Some((index, first?)))
            .collect();
        let some = firsts.iter().step_by(firsts.len().div_ceil(16));
        for until in ENDS.into_iter().chain(some.flat_map(|(_, first)| around(*first))) {
            let in_time = firsts.iter().filter(|(_, first)| first.is_at_most(until));
            let expected: Vec<_> = in_time.copied().collect();
            let options = Options::within(d).until(until);
            let mut found = Vec::new();
            trajectories
                .collisions::<K>(&vertices, options, |index, collision| {
                    found.push((index, collision.time()));
                })
                .unwrap();
            assert!(found == expected, "vertices until {until:e} within {d:?}");
            let mut found = Vec::new();
            batch::Queries::<K>::new(&queries)
                .collisions(options, |index, collision| found.push((index, collision.time())))
                .unwrap();
            assert!(found == expected, "points until {until:e} within {d:?}");
        }
    }
}

/// A vertex reaches the plane of a resting face at t = 1/2 exactly, inside of the face and beside it.
#[test]
fn contact_exactly_at_the_last_time() {
    let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 3.0, 0.0]];
    let falls_at = |[x, y]: [f64; 2]| vertex_against(face, [x, y, 1.0], [x, y, -1.0]);
    let inside = falls_at([0.25, 0.75]);
    let collision = inside.collision(Separation::ZERO).unwrap();
    let times = [0.0, 0.25, 0.5f64.next_down(), 0.5, 0.5f64.next_up(), 0.75, 1.0];
    assert_eq!(
        times.map(|time| collision.is_before(time)),
        times.map(|time| time > 0.5)
    );
    for (last, touches) in [(0.5f64.next_down(), false), (0.5, true)] {
        let until = Options::from(Separation::ZERO).until(last);
        assert_eq!(inside.collides(until), touches);
        let impact = inside.impact(until);
        assert_eq!(impact.map(|impact| impact.time.lower()), touches.then_some(0.5));
        assert_eq!(
            impact.map(|impact| impact.parameters),
            touches.then_some([0.25; 2])
        );
        let intervals: Vec<_> = inside.intervals(until).into_iter().collect();
        assert_eq!(intervals.len(), usize::from(touches));
        assert!(
            intervals
                .iter()
                .all(|interval| interval.is_moment && interval.start.lower() == 0.5)
        );
        assert!(!falls_at([0.625, 1.5]).collides(until));
    }
}

for_each_kind! {
    of_single_queries => single_queries;
    of_batches => batches;
}
