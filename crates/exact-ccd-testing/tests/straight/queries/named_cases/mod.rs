//! Named cases with obvious answers.

mod coincident_points;
mod crossing_edges;
mod edges_without_length;
mod extreme_numbers;
mod falling_vertex;
mod flat_face;
mod parallel_edges;
mod sliding_vertex;
mod tilting_face;
mod touching_again;

use exact_ccd::{EdgeEdge, Interval, Kind, Point, Query, Separation, VertexFace};

use exact_ccd_testing::laws::checked;

const TINY: f64 = 5e-324;
const HUGE: f64 = 1.7e308;

/// The face (0, 0), (1, 0), (0, 1) at height 0.
pub(crate) const FACE: [Point; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// A moving vertex and a face at rest.
pub(crate) fn vertex_against(face: [Point; 3], from: Point, to: Point) -> Query<VertexFace> {
    let [v1, v2, v3] = face;
    Query::new([from, v1, v2, v3], [to, v1, v2, v3]).unwrap()
}

/// A moving edge and an edge at rest.
fn edge_against(rest: [Point; 2], from: [Point; 2], to: [Point; 2]) -> Query<EdgeEdge> {
    let [b0, b1] = rest;
    Query::new([from[0], from[1], b0, b1], [to[0], to[1], b0, b1]).unwrap()
}

/// A query whose points are linear functions of s = 2 t − 1.
fn during<K: Kind<Points = [Point; 4]>>(points: impl Fn(f64) -> [Point; 4]) -> Query<K> {
    Query::new(points(-1.0), points(1.0)).unwrap()
}

/// Checks that the primitives touch in these intervals only, whose ends are all f64.
#[track_caller]
pub(crate) fn touches_within<K: Kind>(query: &Query<K>, d: Separation, expected: &[[f64; 2]]) {
    let intervals = checked(query, d);
    let ends = |interval: &Interval| {
        let [start, end] = [interval.start, interval.end];
        assert!(start.is_exact() && end.is_exact(), "{intervals:?}");
        assert_eq!(interval.is_moment, start == end, "{intervals:?}");
        [start.lower(), end.lower()]
    };
    assert_eq!(intervals.iter().map(ends).collect::<Vec<_>>(), expected);
}

/// Checks that contact is in these intervals only.
#[track_caller]
fn touches_during<K: Kind>(query: &Query<K>, intervals: &[[f64; 2]]) {
    touches_within(query, Separation::ZERO, intervals);
}

/// Checks that contact is at these times only.
#[track_caller]
fn touches_at<K: Kind>(query: &Query<K>, times: &[f64]) {
    let moments: Vec<_> = times.iter().map(|&time| [time; 2]).collect();
    touches_during(query, &moments);
}

/// Checks that contact is just above these f64 only.
#[track_caller]
fn touches_just_above<K: Kind>(query: &Query<K>, times: &[f64]) {
    let found = checked(query, Separation::ZERO);
    assert_eq!(found.count(), Some(times.len()), "{found:?}");
    for (Interval { start, .. }, time) in found.into_iter().zip(times) {
        assert_eq!((start.lower(), start.is_exact()), (*time, false));
    }
}

#[track_caller]
fn never_touches<K: Kind>(query: &Query<K>) {
    touches_at(query, &[]);
}
