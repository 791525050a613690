//! Statements that these filters prove, compared with the definition, for separations next to the distance.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::beside_contact;
use super::crossing::Crossings;
use super::scaled::Scaled;
use super::snapshot::Headed;
use super::starts_within;
use crate::distance::{DistanceBounds, Separation};
use crate::exact::{self, FirstWithin};
use crate::filter::hull::Hull;
use crate::kind::{EdgeEdge, Kind, VertexEdge, VertexFace, VertexVertex};
use crate::point::Point;
use crate::query::Query;

/// The accuracy that the documentation promises of parameters and normals.
const ACCURACY: f64 = 1.0 / (1_u64 << 32) as f64;

/// Times at which distances are compared.
const TIMES: [f64; 5] = [0.0, 0.1875, 0.5, 0.75, 1.0];

/// Two of three have small integers as coordinates, so that many are degenerate.
fn queries<K: Kind>(count: usize) -> impl Iterator<Item = Query<K>> {
    let mut random = fastrand::Rng::with_seed(1);
    (0..count).map(move |index| {
        let mut points = || {
            let mut points = K::Points::default();
            points.as_mut().fill_with(|| -> Point {
                [(); 3].map(|()| match index % 3 {
                    0 => 2.0 * random.f64() - 1.0,
                    _ => f64::from(random.i32(-3..=3)),
                })
            });
            points
        };
        Query::new(points(), points()).expect("the numbers are finite")
    })
}

/// Separations next to the distances at some times, and not far from them.
fn separations<K: Kind>(query: &Query<K>) -> Vec<f64> {
    let mut all = Vec::new();
    for t in TIMES {
        let d = exact::distance_at(query, t).lower;
        all.extend([
            0.75 * d,
            d * (1.0 - 1e-12),
            d.next_down(),
            d,
            d.next_up(),
            d * (1.0 + 1e-12),
        ]);
    }
    all.retain(|&d| d > 0.0);
    all
}

/// The comparison of the distance at a time with d.
fn compare<K: Kind>(query: &Query<K>, t: f64, d: f64) -> Ordering {
    let DistanceBounds { lower, upper } = exact::distance_at(query, t);
    if lower == upper {
        lower.total_cmp(&d)
    } else if d <= lower {
        Ordering::Greater
    } else {
        Ordering::Less
    }
}

/// Times from one to another one.
fn between(from: f64, to: f64) -> impl Iterator<Item = f64> {
    [0.0, 0.125, 0.5, 0.875, 1.0]
        .into_iter()
        .map(move |s| from + s * (to - from))
}

/// Calls a function with queries, separations, and the scaled numbers of both.
fn for_all<K: Kind>(count: usize, mut check: impl FnMut(&Query<K>, &Hull<f64>, &Scaled, f64)) {
    for query in queries::<K>(count) {
        let hull = Hull::new::<K>(&query.four());
        for d in separations(&query) {
            if let Some(scaled) = Scaled::new(&hull, d) {
                check(&query, &hull, &scaled, d);
            }
        }
    }
}

/// Stretches that are free, and times at which the primitives are within d.
fn stretches<K: Kind>() {
    let mut proved = [0; 4];
    for_all::<K>(24, |query, _, scaled, d| {
        let crossings = Crossings::new(query, scaled);
        if starts_within::<K>(scaled) {
            assert_ne!(compare(query, 0.0, d), Ordering::Greater, "{query:?} {d}");
            proved[0] += 1;
        }
        for pair in TIMES.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let free = crossings.advancement.free_after::<K>(from, to);
            for t in between(from, free).filter(|&t| t < free) {
                assert_eq!(compare(query, t, d), Ordering::Greater, "{query:?} {d} {t}");
                proved[1] += 1;
            }
            let [now, then] = [from, to].map(|t| crossings.precise.at::<K>(t));
            let [headed, arrived] = [&now, &then].map(Headed::new);
            if headed
                .zip(arrived)
                .is_some_and(|(headed, arrived)| headed.is_beyond_across(&arrived))
            {
                for t in between(from, to) {
                    assert_eq!(compare(query, t, d), Ordering::Greater, "{query:?} {d} {t}");
                }
                proved[2] += 1;
            }
            if now.is_within() {
                assert_eq!(compare(query, from, d), Ordering::Less, "{query:?} {d} {from}");
                proved[3] += 1;
            }
        }
    });
    assert!(proved.iter().all(|&count| count > 20), "{proved:?}");
}

#[test]
fn stretches_of_time_are_free_or_within_the_separation() {
    stretches::<VertexFace>();
    stretches::<EdgeEdge>();
    stretches::<VertexEdge>();
    stretches::<VertexVertex>();
}

/// The first time, all intervals, and the closest points.
fn answers<K: Kind>() {
    let mut proved = [0; 4];
    for_all::<K>(24, |query, hull, scaled, d| {
        let separation = Separation::new(d).expect("positive and finite");
        let crossings = Crossings::new(query, scaled);
        let truth = FirstWithin::of(query, separation);
        let time = truth.as_ref().map(FirstWithin::time);
        let expects = |first| assert_eq!(first, time, "{query:?} {d}");
        if compare(query, 0.0, d) == Ordering::Greater {
            if let Some(first) = crossings.first_between::<K>([0.0, 1.0]) {
                expects(first);
                proved[0] += 1;
            }
            if let Some(first) = beside_contact::first_after(query, hull, scaled, d, 0.0) {
                expects(Some(first));
            }
        }
        let Some(truth) = truth else { return };
        let first = truth.time();
        if let Some(intervals) = crossings.intervals::<K>(first) {
            assert_eq!(intervals, truth.intervals(), "{query:?} {d}");
            proved[1] += 1;
        }
        if let Some(found) = crossings
            .approach::<K>(first)
            .and_then(|approach| approach.impact::<K>(first))
        {
            let exactly = truth.impact::<K>();
            let differences = found.parameters.into_iter().zip(exactly.parameters);
            let normals = found
                .normal
                .into_iter()
                .flatten()
                .zip(exactly.normal.into_iter().flatten());
            for (x, y) in differences.chain(normals) {
                assert!((x - y).abs() <= ACCURACY, "{found:?} {exactly:?} {query:?} {d}");
            }
            assert_eq!(found.normal.is_some(), exactly.normal.is_some());
            proved[2] += 1;
        }
        proved[3] += 1;
    });
    assert!(proved.iter().all(|&count| count > 20), "{proved:?}");
}

#[test]
fn answers_are_those_of_the_definition() {
    answers::<VertexFace>();
    answers::<EdgeEdge>();
    answers::<VertexEdge>();
    answers::<VertexVertex>();
}
