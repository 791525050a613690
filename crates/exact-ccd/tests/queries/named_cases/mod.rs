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

use exact_ccd::{ContactTimes, EdgeEdge, Kind, Point, Query, VertexFace};

use crate::laws::checked_times;

const TINY: f64 = 5e-324;
const HUGE: f64 = 1.7e308;

/// The face (0, 0), (1, 0), (0, 1) at height 0.
const FACE: [Point; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// A moving vertex and a face at rest.
fn vertex_against(face: [Point; 3], from: Point, to: Point) -> Query<VertexFace> {
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

/// Checks that contact is at these times only, all of them f64.
#[track_caller]
fn touches_at<K: Kind>(query: &Query<K>, times: &[f64]) {
    let expected: Vec<_> = times.iter().map(|&time| (time, true)).collect();
    assert_eq!(finitely(query), expected);
}

/// Checks that contact is just above these f64 only.
#[track_caller]
fn touches_just_above<K: Kind>(query: &Query<K>, times: &[f64]) {
    let expected: Vec<_> = times.iter().map(|&time| (time, false)).collect();
    assert_eq!(finitely(query), expected);
}

#[track_caller]
fn finitely<K: Kind>(query: &Query<K>) -> Vec<(f64, bool)> {
    let ContactTimes::Finite(times) = checked_times(query) else {
        panic!("contact for an interval of time");
    };
    times.iter().map(|time| (time.lower(), time.is_exact())).collect()
}

/// Checks that contact lasts for an interval from this time on.
#[track_caller]
fn touches_from<K: Kind>(query: &Query<K>, time: f64) {
    let ContactTimes::Interval { first } = checked_times(query) else {
        panic!("contact at single times");
    };
    assert_eq!((first.lower(), first.is_exact()), (time, true));
}

#[track_caller]
fn never_touches<K: Kind>(query: &Query<K>) {
    touches_at(query, &[]);
}
