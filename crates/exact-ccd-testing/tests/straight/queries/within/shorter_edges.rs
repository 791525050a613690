//! A vertex is an edge of length zero.

use exact_ccd::{EdgeEdge, Kind, Separation, VertexEdge, VertexVertex};
use proptest::prelude::*;

use crate::queries::families::{cases, extreme, ordinary, rule};
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::laws::assert_same_times;
use exact_ccd_testing::runner::for_all;

/// Two edges among the four points have the answers of a kind.
fn are_edges<K: Kind>(orders: &[[usize; 4]]) {
    let points = prop_oneof![40 => ordinary(), 1 => extreme()];
    for_all(cases(5_000), (points, rule()), |(points, rule)| {
        let d = rule.separation::<K>(&points);
        let query = query::<K>(&points);
        for order in orders {
            let edges = points.map(|now| order.map(|i| now[i]));
            let edges = exact_ccd_testing::kinds::query::<EdgeEdge>(&edges);
            for d in [d, Separation::ZERO] {
                assert_same_times((&query, d), (&edges, d));
            }
            assert_eq!(query.distance_at(0.5), edges.distance_at(0.5), "{query:?}");
        }
    });
}

#[test]
fn a_vertex_and_an_edge_are_edges() {
    are_edges::<VertexEdge>(&[[0, 0, 2, 3], [3, 2, 0, 0]]);
}

#[test]
fn two_vertices_are_edges() {
    are_edges::<VertexVertex>(&[[0, 0, 3, 3]]);
}
