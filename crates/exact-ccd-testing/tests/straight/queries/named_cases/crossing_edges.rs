//! Two edges.

use exact_ccd::{EdgeEdge, Point, Query};

use super::{TINY, during, edge_against, never_touches, touches_at, touches_during};

/// From (−1, 0, 0) to (1, 0, 0).
const REST: [Point; 2] = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]];

fn across(x: f64, low: f64, high: f64, z: f64) -> [Point; 2] {
    [[x, low, z], [x, high, z]]
}

#[test]
fn cross_in_their_middles() {
    touches_at(
        &edge_against(REST, across(0.0, -1.0, 1.0, 1.0), across(0.0, -1.0, 1.0, -1.0)),
        &[0.5],
    );
}

#[test]
fn cross_at_ends() {
    for (x, low, high) in [
        (0.5, 0.0, 1.0),
        (1.0, -1.0, 1.0),
        (1.0, 0.0, 1.0),
        (-1.0, -1.0, 0.0),
    ] {
        touches_at(
            &edge_against(REST, across(x, low, high, 1.0), across(x, low, high, -1.0)),
            &[0.5],
        );
    }
}

#[test]
fn pass_by_each_other_at_the_least_distance() {
    for (x, low, high) in [
        (1.0f64.next_up(), -1.0, 1.0),
        (0.0, TINY, 1.0),
        (0.0, -1.0, -TINY),
    ] {
        never_touches(&edge_against(
            REST,
            across(x, low, high, 1.0),
            across(x, low, high, -1.0),
        ));
    }
}

#[test]
fn touch_at_the_start_only() {
    touches_at(
        &edge_against(REST, across(0.0, -1.0, 1.0, 0.0), across(0.0, -1.0, 1.0, 1.0)),
        &[0.0],
    );
}

#[test]
fn touch_at_the_end_only() {
    touches_at(
        &edge_against(REST, across(0.0, -1.0, 1.0, 1.0), across(0.0, -1.0, 1.0, 0.0)),
        &[1.0],
    );
}

#[test]
fn rest_across_each_other() {
    let edge = across(0.0, -1.0, 1.0, 0.0);
    touches_during(&edge_against(REST, edge, edge), &[[0.0, 1.0]]);
}

#[test]
fn slide_across_each_other() {
    touches_during(
        &edge_against(REST, across(-2.0, -1.0, 1.0, 0.0), across(2.0, -1.0, 1.0, 0.0)),
        &[[0.25, 0.75]],
    );
}

/// The lines y = s, z = s x − s / 4 and x = s y, z = 0 meet when s³ = s / 4.
#[test]
fn cross_three_times() {
    let query: Query<EdgeEdge> = during(|s| {
        let end = |x: f64| [x, s, s * x - 0.25 * s];
        [end(-4.0), end(4.0), [-4.0 * s, -4.0, 0.0], [4.0 * s, 4.0, 0.0]]
    });
    touches_at(&query, &[0.25, 0.5, 0.75]);
}

/// The lines y = s, z = s x and x = s y, z = 0 meet when s³ = 0.
#[test]
fn cross_at_a_triple_root() {
    let query: Query<EdgeEdge> = during(|s| {
        let end = |x: f64| [x, s, s * x];
        [end(-4.0), end(4.0), [-4.0 * s, -4.0, 0.0], [4.0 * s, 4.0, 0.0]]
    });
    touches_at(&query, &[0.5]);
}
