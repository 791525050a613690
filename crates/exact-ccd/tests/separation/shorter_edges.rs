//! A vertex is an edge of length zero.

use exact_ccd::{EdgeEdge, Query, VertexEdge, VertexVertex};

use crate::families::{cases, extreme, ordinary, rule};
use crate::kinds::FromFour;
use crate::laws::bits;
use crate::primitives::Points;
use crate::runner::for_all;
use proptest::prelude::*;

fn points() -> impl Strategy<Value = Points> {
    prop_oneof![40 => ordinary(), 1 => extreme()]
}

fn edges(points: &Points, order: [usize; 4]) -> Query<EdgeEdge> {
    let [start, end] = points.map(|now| order.map(|i| now[i]));
    Query::new(start, end).unwrap()
}

#[test]
fn a_vertex_and_an_edge_are_edges() {
    for_all(cases(5_000), (points(), rule()), |(points, rule)| {
        let d = rule.separation::<VertexEdge>(&points);
        let query = VertexEdge::query(&points);
        for edges in [edges(&points, [0, 0, 2, 3]), edges(&points, [3, 2, 0, 0])] {
            assert_eq!(
                bits(&query.intervals_within(d)),
                bits(&edges.intervals_within(d)),
                "{d:?}: {query:?}"
            );
            assert_eq!(query.contact_times(), edges.contact_times(), "{query:?}");
            assert_eq!(query.collides(), edges.collides(), "{query:?}");
            assert_eq!(query.distance_at(0.5), edges.distance_at(0.5), "{query:?}");
        }
    });
}

#[test]
fn two_vertices_are_edges() {
    for_all(cases(5_000), (points(), rule()), |(points, rule)| {
        let d = rule.separation::<VertexVertex>(&points);
        let query = VertexVertex::query(&points);
        let edges = edges(&points, [0, 0, 2, 2]);
        assert_eq!(
            bits(&query.intervals_within(d)),
            bits(&edges.intervals_within(d)),
            "{d:?}: {query:?}"
        );
        assert_eq!(query.contact_times(), edges.contact_times(), "{query:?}");
        assert_eq!(query.collides(), edges.collides(), "{query:?}");
        assert_eq!(query.distance_at(0.5), edges.distance_at(0.5), "{query:?}");
    });
}
