//! Numbers at the ends of the range.

use exact_ccd::{Point, Query, VertexFace};

use super::{HUGE, TINY, edge_against, never_touches, touches_at, touches_just_above, vertex_against};

const FACE: [Point; 3] = [[-HUGE, -HUGE, 0.0], [HUGE, -HUGE, 0.0], [0.0, HUGE, 0.0]];

fn falls(from: f64, to: f64) -> Query<VertexFace> {
    vertex_against(FACE, [TINY, -TINY, from], [TINY, -TINY, to])
}

#[test]
fn cross_half_way() {
    touches_at(&falls(TINY, -TINY), &[0.5]);
    touches_at(&falls(HUGE, -HUGE), &[0.5]);
    touches_at(&falls(f64::MAX, f64::MIN), &[0.5]);
}

#[test]
fn cross_at_a_third() {
    touches_just_above(&falls(TINY, -2.0 * TINY), &[1.0 / 3.0]);
}

#[test]
fn cross_before_the_first_f64_and_after_the_last() {
    // At about t = 5e-324 / 1.7e308, and at 1 minus that.
    touches_just_above(&falls(TINY, -HUGE), &[0.0]);
    touches_just_above(&falls(HUGE, -TINY), &[1.0f64.next_down()]);
}

#[test]
fn stay_apart_by_the_least_distance() {
    never_touches(&falls(TINY, HUGE));
    never_touches(&falls(HUGE, TINY));
    never_touches(&falls(TINY, TINY));
}

/// The upper corner is at the smallest distance from the x-axis, and the edges leave it almost
/// along that axis.
#[test]
fn make_faces_that_are_all_but_flat() {
    let face = [[-HUGE, -1.0, 0.0], [HUGE, -1.0, 0.0], [0.0, TINY, 0.0]];
    touches_at(&vertex_against(face, [0.0, TINY, 1.0], [0.0, TINY, -1.0]), &[0.5]);
    never_touches(&vertex_against(face, [TINY, TINY, 1.0], [TINY, TINY, -1.0]));
    touches_at(&vertex_against(face, [TINY, 0.0, 1.0], [TINY, 0.0, -1.0]), &[0.5]);
}

#[test]
fn make_edges_that_cross_far_out() {
    let rest = [[-HUGE, -HUGE, 0.0], [HUGE, HUGE, 0.0]];
    let across = |z: f64| [[HUGE, HUGE, z], [HUGE, -HUGE, z]];
    touches_at(&edge_against(rest, across(TINY), across(-TINY)), &[0.5]);
    let beside = |z: f64| [[f64::MAX, f64::MAX, z], [f64::MAX, -HUGE, z]];
    never_touches(&edge_against(rest, beside(TINY), beside(-TINY)));
}
