//! Parallel edges.

use exact_ccd::{EdgeEdge, Point};

use super::{TINY, during, edge_against, never_touches, touches_at, touches_during};

const REST: [Point; 2] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]];

fn along(start: f64, end: f64, z: f64) -> [Point; 2] {
    [[start, 0.0, z], [end, 0.0, z]]
}

#[test]
fn fall_through_each_other() {
    for (start, end) in [(0.25, 0.75), (-1.0, 2.0), (0.5, 3.0), (1.0, 3.0), (2.0, -1.0)] {
        touches_at(
            &edge_against(REST, along(start, end, 1.0), along(start, end, -1.0)),
            &[0.5],
        );
    }
    for (start, end) in [(1.0f64.next_up(), 2.0), (-1.0, -TINY)] {
        never_touches(&edge_against(
            REST,
            along(start, end, 1.0),
            along(start, end, -1.0),
        ));
    }
}

#[test]
fn slide_along_each_other() {
    touches_during(
        &edge_against(REST, along(2.0, 3.0, 0.0), along(0.0, 1.0, 0.0)),
        &[[0.5, 1.0]],
    );
    touches_during(
        &edge_against(REST, along(2.0, 3.0, 0.0), along(-6.0, -5.0, 0.0)),
        &[[0.125, 0.375]],
    );
    touches_during(
        &edge_against(REST, along(0.0, 1.0, 0.0), along(2.0, 3.0, 0.0)),
        &[[0.0, 0.5]],
    );
    touches_at(
        &edge_against(REST, along(2.0, 3.0, 0.0), along(1.0, 2.0, 0.0)),
        &[1.0],
    );
    never_touches(&edge_against(
        REST,
        along(2.0, 3.0, 0.0),
        along(1.0f64.next_up(), 2.0, 0.0),
    ));
}

#[test]
fn rest_on_each_other() {
    touches_during(&edge_against(REST, REST, REST), &[[0.0, 1.0]]);
    touches_during(
        &edge_against(REST, along(1.0, 2.0, 0.0), along(1.0, 2.0, 0.0)),
        &[[0.0, 1.0]],
    );
    never_touches(&edge_against(REST, along(2.0, 3.0, 0.0), along(2.0, 3.0, 0.0)));
}

/// An edge turns in a plane, and lies along the other one at one time.
#[test]
fn are_so_for_a_moment() {
    let beside = |s: f64| [[2.0, -s, 0.0], [3.0, s, 0.0], REST[0], REST[1]];
    never_touches::<EdgeEdge>(&during(beside));
    // The end on the left comes from above and touches the end of the edge at rest.
    let end_to_end = |s: f64| [[1.0, -s, 0.0], [3.0, s, 0.0], REST[0], REST[1]];
    touches_at::<EdgeEdge>(&during(end_to_end), &[0.5]);
}
