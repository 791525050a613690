//! A vertex in the plane of a face.

use exact_ccd::{Query, VertexFace};

use super::{FACE, TINY, never_touches, touches_at, touches_during, vertex_against};

#[test]
fn rests_in_it() {
    touches_during(
        &vertex_against(FACE, [0.25, 0.25, 0.0], [0.25, 0.25, 0.0]),
        &[[0.0, 1.0]],
    );
}

#[test]
fn rests_on_its_corner() {
    touches_during(&vertex_against(FACE, FACE[1], FACE[1]), &[[0.0, 1.0]]);
}

#[test]
fn rests_beside_it() {
    never_touches(&vertex_against(FACE, [0.75, 0.75, 0.0], [0.75, 0.75, 0.0]));
}

#[test]
fn slides_across_it() {
    // The vertex crosses the edge x = 0 at t = 1/4 and the hypotenuse at t = 7/16.
    touches_during(
        &vertex_against(FACE, [-1.0, 0.25, 0.0], [3.0, 0.25, 0.0]),
        &[[0.25, 0.4375]],
    );
}

#[test]
fn slides_out_of_it() {
    touches_during(
        &vertex_against(FACE, [0.25, 0.25, 0.0], [-0.75, 0.25, 0.0]),
        &[[0.0, 0.25]],
    );
}

#[test]
fn slides_along_its_edge() {
    touches_during(
        &vertex_against(FACE, [-1.0, 0.0, 0.0], [3.0, 0.0, 0.0]),
        &[[0.25, 0.5]],
    );
}

#[test]
fn slides_up_to_it() {
    touches_at(&vertex_against(FACE, [-1.0, 0.25, 0.0], [0.0, 0.25, 0.0]), &[1.0]);
}

#[test]
fn slides_past_its_corner() {
    touches_at(&vertex_against(FACE, [1.0, -1.0, 0.0], [1.0, 1.0, 0.0]), &[0.5]);
}

#[test]
fn moves_along_with_it() {
    let [a, b, c] = FACE;
    let drifts = |height: f64| {
        let start = [[0.25, 0.25, height], a, b, c];
        Query::<VertexFace>::new(start, start.map(|[x, y, z]| [x + 4.0, y - 2.0, z])).unwrap()
    };
    touches_during(&drifts(0.0), &[[0.0, 1.0]]);
    never_touches(&drifts(TINY));
}
