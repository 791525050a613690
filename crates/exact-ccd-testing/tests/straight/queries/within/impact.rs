//! The closest points at the first time, compared with their definition.

use exact_ccd::{EdgeEdge, VertexFace};
use proptest::prelude::*;

use crate::queries::families::{cases, rule};
use exact_ccd_testing::families::{degenerate, fractions, small_integers};
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::primitives::{Primitives, at, combine, dot};
use exact_ccd_testing::runner::for_all;

fn connects_the_closest_points<K: Primitives>() {
    let points = prop_oneof![
        small_integers(2),
        small_integers(8),
        degenerate(small_integers(2)),
        fractions()
    ];
    for_all(cases(4_000), (points, rule()), |(points, rule)| {
        let d = rule.separation::<K>(&points);
        let query = query::<K>(&points);
        let Some(impact) = query.impact(d).filter(|_| !d.is_zero()) else {
            return;
        };
        let [u, v] = impact.parameters;
        assert!(u >= 0.0 && v >= 0.0, "{impact:?}");
        // The error of the parameters is at most 2⁻³², hence the error of the points' difference a few times
        // 2⁻³² of their size.
        let x = combine(K::weights(u, v), at(&points, impact.time.lower()));
        let distance = query.distance_at(impact.time.lower()).unwrap().lower;
        let length = dot(x, x).sqrt();
        assert!(
            (length - distance).abs() < 1e-7,
            "{length}, {distance}: {impact:?}, {query:?}"
        );
        match impact.normal {
            Some(normal) => {
                assert!((dot(normal, normal) - 1.0).abs() < 1e-12, "{impact:?}");
                assert!((dot(normal, x) - length).abs() < 1e-7, "{impact:?}, {query:?}");
            }
            None => assert!(distance == 0.0, "{impact:?}, {query:?}"),
        }
    });
}

#[test]
fn connects_the_closest_points_of_a_vertex_and_a_face() {
    connects_the_closest_points::<VertexFace>();
}

#[test]
fn connects_the_closest_points_of_edges() {
    connects_the_closest_points::<EdgeEdge>();
}
