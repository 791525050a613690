//! Edges without length.

use exact_ccd::{EdgeEdge, Point, Query};

use super::{TINY, during, edge_against, never_touches, touches_at, touches_during};

fn point(x: f64, y: f64, z: f64) -> [Point; 2] {
    [[x, y, z]; 2]
}

#[test]
fn meet_edges() {
    let rest = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
    touches_at(
        &edge_against(rest, point(0.5, 0.0, 1.0), point(0.5, 0.0, -1.0)),
        &[0.5],
    );
    touches_at(
        &edge_against(rest, point(1.0, 0.0, 1.0), point(1.0, 0.0, -1.0)),
        &[0.5],
    );
    never_touches(&edge_against(rest, point(0.5, TINY, 1.0), point(0.5, TINY, -1.0)));
    touches_during(
        &edge_against(rest, point(-3.0, 0.0, 0.0), point(5.0, 0.0, 0.0)),
        &[[0.25, 0.5]],
    );
}

#[test]
fn meet_each_other() {
    let origin = point(0.0, 0.0, 0.0);
    touches_at(
        &edge_against(origin, point(1.0, 2.0, 3.0), point(-1.0, -2.0, -3.0)),
        &[0.5],
    );
    never_touches(&edge_against(
        origin,
        point(1.0, 2.0, 3.0),
        point(-1.0, -2.0, -3.0f64.next_up()),
    ));
    touches_during(&edge_against(origin, origin, origin), &[[0.0, 1.0]]);
}

/// In one plane with the other edge at all times; the line y = s x − 1/4 passes over (s, 0) when s²
/// = 1/4.
#[test]
fn meet_an_edge_twice_in_a_plane() {
    let query: Query<EdgeEdge> = during(|s| {
        let end = |x: f64| [x, s * x - 0.25, 0.0];
        [end(-4.0), end(4.0), [s, 0.0, 0.0], [s, 0.0, 0.0]]
    });
    touches_at(&query, &[0.25, 0.75]);
}
