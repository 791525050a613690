//! Points that all coincide.

use exact_ccd::{EdgeEdge, Point, Query, VertexFace};

use super::{HUGE, TINY, touches_at, touches_during};

fn both_touch_at_all_times(start: Point, end: Point) {
    touches_during(
        &Query::<VertexFace>::new([start; 4], [end; 4]).unwrap(),
        &[[0.0, 1.0]],
    );
    touches_during(
        &Query::<EdgeEdge>::new([start; 4], [end; 4]).unwrap(),
        &[[0.0, 1.0]],
    );
}

#[test]
fn touch_at_all_times() {
    for x in [0.0, -0.0, 1.0, TINY, HUGE, f64::MAX] {
        both_touch_at_all_times([x; 3], [x; 3]);
        both_touch_at_all_times([x, 0.0, -x], [-x, 3.0, 0.1]);
    }
}

#[test]
fn part_at_once() {
    let (origin, away) = ([0.0; 3], [TINY, HUGE, 1.0]);
    let face = Query::<VertexFace>::new([origin; 4], [away, origin, origin, origin]).unwrap();
    touches_at(&face, &[0.0]);
    let edges = Query::<EdgeEdge>::new([origin; 4], [away, away, origin, origin]).unwrap();
    touches_at(&edges, &[0.0]);
}

#[test]
fn stay_in_touch_at_one_corner() {
    let (origin, away) = ([0.0; 3], [TINY, HUGE, 1.0]);
    touches_during(
        &Query::<VertexFace>::new([origin; 4], [origin, away, away, origin]).unwrap(),
        &[[0.0, 1.0]],
    );
    touches_during(
        &Query::<EdgeEdge>::new([origin; 4], [origin, away, origin, away]).unwrap(),
        &[[0.0, 1.0]],
    );
}

/// All points are in one place at one end of the step, and in general position at the other.
#[test]
fn meet_or_part_in_general_position() {
    let place = [[0.5, -1.0, 3.0]; 4];
    let face = [
        [0.25, 0.25, 1.0],
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    let edges = [
        [-1.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [0.0, -1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    touches_at(&Query::<VertexFace>::new(place, face).unwrap(), &[0.0]);
    touches_at(&Query::<VertexFace>::new(face, place).unwrap(), &[1.0]);
    touches_at(&Query::<EdgeEdge>::new(place, edges).unwrap(), &[0.0]);
    touches_at(&Query::<EdgeEdge>::new(edges, place).unwrap(), &[1.0]);
}

/// The edges cross at t = 1/2, and two of their vertices are in one place at t = 1.
#[test]
fn meet_at_a_corner_after_a_crossing() {
    let start = [
        [-1.0, 0.0, 1.0],
        [1.0, -1.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    let end = [
        [-1.0, 0.0, -1.0],
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    let edges = Query::<EdgeEdge>::new(start, end).unwrap();
    touches_at(&edges, &[0.5, 1.0]);
}

/// Two edges that cross in a plane shrink to a point.
#[test]
fn cross_until_they_are_a_point() {
    let start = [
        [-1.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    let edges = Query::<EdgeEdge>::new(start, [[0.0; 3]; 4]).unwrap();
    touches_during(&edges, &[[0.0, 1.0]]);
}
