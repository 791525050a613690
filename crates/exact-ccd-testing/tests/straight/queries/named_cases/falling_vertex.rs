//! A vertex that falls on a face.

use exact_ccd::{Query, Separation, VertexFace};

use super::{FACE, TINY, never_touches, touches_at, touches_just_above, vertex_against};
use exact_ccd_testing::laws::checked;

fn falls(x: f64, y: f64) -> Query<VertexFace> {
    vertex_against(FACE, [x, y, 1.0], [x, y, -1.0])
}

#[test]
fn passes_through_it() {
    touches_at(&falls(0.25, 0.25), &[0.5]);
}

#[test]
fn passes_through_it_at_a_third() {
    let query = vertex_against(FACE, [0.25, 0.25, 1.0], [0.25, 0.25, -2.0]);
    // The f64 nearest to 1/3 is below it.
    touches_just_above(&query, &[1.0 / 3.0]);
}

#[test]
fn passes_through_its_edges() {
    for (x, y) in [(0.5, 0.0), (0.0, 0.5), (0.5, 0.5), (0.25, 0.75)] {
        touches_at(&falls(x, y), &[0.5]);
    }
}

#[test]
fn passes_through_its_corners() {
    for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)] {
        touches_at(&falls(x, y), &[0.5]);
    }
}

#[test]
fn passes_by_at_the_least_distance() {
    let half = 0.5f64.next_up();
    for (x, y) in [(0.5, -TINY), (-TINY, 0.5), (0.5, half), (half, 0.5), (1.0, TINY)] {
        never_touches(&falls(x, y));
    }
}

#[test]
fn hits_both_faces_at_the_edge_that_they_share() {
    let [a, b, c] = FACE;
    let other = [[1.0, 1.0, 0.0], c, b];
    for x in [0.0, 0.125, 0.75, 1.0] {
        let (from, to) = ([x, 1.0 - x, 1.0], [x, 1.0 - x, -1.0]);
        touches_at(&vertex_against([a, b, c], from, to), &[0.5]);
        touches_at(&vertex_against(other, from, to), &[0.5]);
    }
}

/// The vertex is on either side of the shared edge, where 1 − x is rounded.
#[test]
fn does_not_slip_through_between_two_faces() {
    let [a, b, c] = FACE;
    for x in [0.1, 0.2, 0.3, 1e-17, 1.0 / 3.0] {
        let (from, to) = ([x, 1.0 - x, 1.0], [x, 1.0 - x, -1.0]);
        let hits = [[a, b, c], [[1.0, 1.0, 0.0], c, b]]
            .map(|face| checked(&vertex_against(face, from, to), Separation::ZERO).count() == Some(1));
        assert!(hits[0] != hits[1], "{x}: {hits:?}");
    }
}

#[test]
fn only_begins_on_it() {
    touches_at(
        &vertex_against(FACE, [0.25, 0.25, 0.0], [0.25, 0.25, 1.0]),
        &[0.0],
    );
}

#[test]
fn only_ends_on_it() {
    touches_at(
        &vertex_against(FACE, [0.25, 0.25, 1.0], [0.25, 0.25, 0.0]),
        &[1.0],
    );
}

#[test]
fn stops_short_of_it() {
    never_touches(&vertex_against(FACE, [0.25, 0.25, 1.0], [0.25, 0.25, TINY]));
}

#[test]
fn starts_below_it_on_the_negative_zero() {
    touches_at(
        &vertex_against(FACE, [0.25, 0.25, -0.0], [0.25, 0.25, -1.0]),
        &[0.0],
    );
}
