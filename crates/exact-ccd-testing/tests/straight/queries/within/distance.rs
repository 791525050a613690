//! The distance at a time, compared with a search, and with the times within that distance.

use exact_ccd::{DistanceBounds, EdgeEdge, Kind, Point, Query, VertexEdge, VertexFace, VertexVertex};
use proptest::prelude::*;

use crate::queries::each_kind::for_each_kind;
use crate::queries::families::{cases, extreme, ordinary, rule};
use exact_ccd_testing::families::{degenerate, small_integers};
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::laws::contain;
use exact_ccd_testing::primitives::{Points, Primitives, at, combine, dot};
use exact_ccd_testing::runner::for_all;

fn bounds<K: Kind>(query: &Query<K>, t: f64) -> DistanceBounds {
    query.distance_at(t).unwrap()
}

/// A time is in the intervals exactly if the distance at this time is at most d.
fn decides_membership<K: Kind>() {
    let points = prop_oneof![20 => ordinary(), 1 => extreme()];
    for_all(cases(4_000), (points, rule()), |(points, rule)| {
        let d = rule.separation::<K>(&points);
        let query = query::<K>(&points);
        let intervals = query.intervals(d);
        for eighths in 0..=8 {
            let t = f64::from(eighths) / 8.0;
            let DistanceBounds { lower, upper } = bounds(&query, t);
            assert!(upper == lower || upper == lower.next_up(), "{query:?}");
            // Between two adjacent f64, the distance is above the lower one.
            let is_within = upper <= d.get();
            assert_eq!(contain(&intervals, t), is_within, "at {t}, {d:?}: {query:?}");
        }
    });
}

fn equals_d_at_the_first_time<K: Kind>() {
    for_all(cases(4_000), (ordinary(), rule()), |(points, rule)| {
        let d = rule.separation::<K>(&points);
        let query = query::<K>(&points);
        let Some(collision) = query.collision(d) else {
            return;
        };
        let first = collision.time();
        let then @ DistanceBounds { lower, upper } = bounds(&query, first.lower());
        if !first.is_exact() {
            assert!(upper > d.get(), "{d:?}: {query:?}");
        } else if first.lower() > 0.0 {
            assert_eq!([lower, upper], [d.get(); 2], "{d:?}: {query:?}");
        } else {
            assert!(upper <= d.get(), "{d:?}: {query:?}");
        }
        let d = d.get();
        let at_collision = if first.is_start() {
            then
        } else {
            DistanceBounds { lower: d, upper: d }
        };
        assert_eq!(collision.distance(), at_collision, "{d:?}: {query:?}");
    });
}

for_each_kind! {
    decides_whether_a_time_is_within_it => decides_membership;
    is_the_one_asked_for_at_the_first_time => equals_d_at_the_first_time;
}

/// The least squared length of F over the domain at a time, by ternary search in u, and in v for
/// each u.
fn searched<K: Primitives>(points: &[Point; 4]) -> f64 {
    let squared = |u: f64, v: f64| {
        let x = combine(K::weights(u, v), *points);
        dot(x, x)
    };
    let is_triangle = K::DOMAIN.len() == 3;
    let inner = |u: f64| least(if is_triangle { 1.0 - u } else { 1.0 }, |v| squared(u, v));
    least(1.0, inner)
}

/// The least value of a convex function on [0, high].
fn least(mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let mut low = 0.0;
    for _ in 0..60 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if f(a) < f(b) {
            high = b;
        } else {
            low = a;
        }
    }
    f(low).min(f(high))
}

fn is_near_the_searched_one<K: Kind>(search: impl Fn(&[Point; 4]) -> f64) {
    let points = prop_oneof![
        small_integers(2),
        small_integers(8),
        degenerate(small_integers(2))
    ];
    for_all(cases(2_000), (points, 0.0..=1.0), |(points, t)| {
        let DistanceBounds { lower, upper } = bounds(&query::<K>(&points), t);
        let near = search(&at(&points, t)).sqrt();
        assert!(
            lower - 1e-6 < near && near < upper + 1e-6,
            "{near}, {lower} at {t}: {points:?}"
        );
    });
}

#[test]
fn is_the_least_over_the_domain() {
    is_near_the_searched_one::<VertexFace>(searched::<VertexFace>);
    is_near_the_searched_one::<EdgeEdge>(searched::<EdgeEdge>);
    let order = |points: &[Point; 4], order: [usize; 4]| order.map(|i| points[i]);
    is_near_the_searched_one::<VertexEdge>(|points| searched::<EdgeEdge>(&order(points, [0, 0, 2, 3])));
    is_near_the_searched_one::<VertexVertex>(|points| searched::<EdgeEdge>(&order(points, [0, 0, 3, 3])));
}

#[test]
fn is_an_error_outside_of_the_step() {
    let query = query::<VertexVertex>(&Points::default());
    for t in [-5e-324, 1.0f64.next_up(), f64::INFINITY, f64::NAN] {
        let error = query.distance_at(t).unwrap_err();
        assert_eq!(error.time.to_bits(), t.to_bits());
    }
    assert_eq!(
        bounds(&query, -0.0),
        DistanceBounds {
            lower: 0.0,
            upper: 0.0
        }
    );
}
