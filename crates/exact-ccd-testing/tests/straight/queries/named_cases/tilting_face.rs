//! A vertex and a face in the plane z = s x, which tilts from one side to the other.

use exact_ccd::{Query, VertexFace};

use super::{TINY, during, never_touches, touches_at, touches_just_above};

/// The vertex is at (s, 0, height), so that it meets the plane when s² = height.
fn at_height(height: f64) -> Query<VertexFace> {
    during(|s| {
        [
            [s, 0.0, height],
            [-4.0, -4.0, -4.0 * s],
            [4.0, -4.0, 4.0 * s],
            [0.0, 4.0, 0.0],
        ]
    })
}

#[test]
fn touches_it_once_without_crossing() {
    touches_at(&at_height(0.0), &[0.5]);
    touches_at(&at_height(-0.0), &[0.5]);
}

#[test]
fn crosses_it_twice() {
    touches_at(&at_height(0.25), &[0.25, 0.75]);
    touches_at(&at_height(1.0), &[0.0, 1.0]);
}

#[test]
fn crosses_it_twice_within_no_time() {
    for height in [2f64.powi(-200), f64::MIN_POSITIVE, TINY] {
        touches_just_above(&at_height(height), &[0.5f64.next_down(), 0.5]);
    }
}

#[test]
fn never_reaches_it() {
    for height in [-0.25, -2f64.powi(-200), -f64::MIN_POSITIVE, -TINY] {
        never_touches(&at_height(height));
    }
}

/// Two times between the same two f64, with s = 3 t − 1 in place of 2 t − 1.
#[test]
fn crosses_it_twice_around_a_third() {
    let at = |s: f64| {
        let height = 2f64.powi(-200);
        [
            [s, 0.0, height],
            [-4.0, -4.0, -4.0 * s],
            [4.0, -4.0, 4.0 * s],
            [0.0, 4.0, 0.0],
        ]
    };
    let query = Query::<VertexFace>::new(at(-1.0), at(2.0)).unwrap();
    touches_just_above(&query, &[1.0 / 3.0, 1.0 / 3.0]);
}

/// The face is sheared along x by s y as well, and the vertex at (1/4, s, 0) meets it when s (1/4 −
/// s²) = 0.
#[test]
fn crosses_it_three_times() {
    let corner = |s: f64, x: f64, y: f64| [x + s * y, y, s * x];
    let query: Query<VertexFace> = during(|s| {
        [
            [0.25, s, 0.0],
            corner(s, -4.0, -4.0),
            corner(s, 4.0, -4.0),
            corner(s, 0.0, 4.0),
        ]
    });
    touches_at(&query, &[0.25, 0.5, 0.75]);
}
