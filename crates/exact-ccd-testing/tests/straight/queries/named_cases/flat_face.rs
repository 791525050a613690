//! A face without area.

use exact_ccd::{Point, Query, VertexFace};

use super::{TINY, during, never_touches, touches_at, touches_during, vertex_against};

const A: Point = [0.0, 0.0, 0.0];
const B: Point = [1.0, 0.0, 0.0];

#[test]
fn is_hit_like_an_edge() {
    for face in [
        [A, B, B],
        [A, A, B],
        [A, B, A],
        [A, B, [0.5, 0.0, 0.0]],
        [[0.25, 0.0, 0.0], A, B],
    ] {
        touches_at(&vertex_against(face, [0.5, 0.0, 1.0], [0.5, 0.0, -1.0]), &[0.5]);
        touches_at(&vertex_against(face, [1.0, 0.0, 1.0], [1.0, 0.0, -1.0]), &[0.5]);
        never_touches(&vertex_against(face, [0.5, TINY, 1.0], [0.5, TINY, -1.0]));
        never_touches(&vertex_against(face, [-TINY, 0.0, 1.0], [-TINY, 0.0, -1.0]));
        touches_during(
            &vertex_against(face, [-1.0, 0.0, 0.0], [3.0, 0.0, 0.0]),
            &[[0.25, 0.5]],
        );
    }
}

#[test]
fn is_hit_like_a_point() {
    touches_at(&vertex_against([A; 3], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]), &[0.5]);
    never_touches(&vertex_against([A; 3], [0.0, TINY, 1.0], [0.0, TINY, -1.0]));
}

#[test]
fn has_none_only_at_the_contact() {
    // The third corner crosses the line of the others at t = 1/2, inside or outside of them.
    let query =
        |corner: f64, x: f64| -> Query<VertexFace> { during(|s| [[x, 0.0, -s], A, B, [corner, s, 0.0]]) };
    touches_at(&query(0.5, 0.25), &[0.5]);
    never_touches(&query(0.5, 1.25));
    touches_at(&query(2.0, 1.25), &[0.5]);
    touches_at(&query(2.0, 2.0), &[0.5]);
    never_touches(&query(2.0, 2.0f64.next_up()));
}
