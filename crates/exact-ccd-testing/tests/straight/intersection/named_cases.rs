//! Named cases with obvious answers.

use exact_ccd::predicates::{EdgeFace, orient3d};
use exact_ccd::{Axis, NonFinite, Point};

const FACE: [Point; 3] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];

#[track_caller]
fn assert_intersects(expected: bool, edge: [Point; 2], face: [Point; 3]) {
    // Products of three underflow or overflow, and all coordinates are multiples of the smallest
    // number.
    for scale in [1.0, 1e-120, 2f64.powi(-1074), 1e120, 2f64.powi(1000)] {
        let scaled = |p: Point| p.map(|x| x * scale);
        let answer = EdgeFace::new(edge.map(scaled), face.map(scaled))
            .unwrap()
            .intersects();
        assert_eq!(answer, expected, "{edge:?} and {face:?} times {scale:e}");
    }
}

#[test]
fn an_edge_pierces_the_face_or_passes_by() {
    for (point, expected) in [
        ([1.0, 1.0], true),
        ([0.0, 0.0], true),
        ([2.0, 2.0], true),
        ([2.0, 0.0], true),
        ([0.0, 3.0], true),
        ([4.0, 0.0], true),
        ([3.0, 2.0], false),
        ([-1.0, 1.0], false),
        ([1.0, -1.0], false),
        ([5.0, 0.0], false),
    ] {
        let [x, y] = point;
        assert_intersects(expected, [[x, y, -1.0], [x, y, 1.0]], FACE);
        assert_intersects(expected, [[x, y, -1.0], [x, y, 0.0]], FACE);
        assert_intersects(expected, [[x, y, 0.0], [x + 1.0, y, 3.0]], FACE);
        assert_intersects(false, [[x, y, 1.0], [x, y, 2.0]], FACE);
    }
}

#[test]
fn an_edge_lies_in_the_plane() {
    let along = |from: [f64; 2], to: [f64; 2]| [from, to].map(|[x, y]| [x, y, 0.0]);
    assert_intersects(true, along([1.0, 1.0], [2.0, 1.0]), FACE);
    assert_intersects(true, along([-1.0, 1.0], [9.0, 1.0]), FACE);
    assert_intersects(true, along([-1.0, 1.0], [1.0, 1.0]), FACE);
    assert_intersects(true, along([-1.0, 0.0], [9.0, 0.0]), FACE);
    assert_intersects(true, along([-1.0, 1.0], [1.0, -1.0]), FACE);
    assert_intersects(true, along([4.0, 0.0], [9.0, 0.0]), FACE);
    assert_intersects(false, along([5.0, 0.0], [9.0, 0.0]), FACE);
    assert_intersects(false, along([-2.0, 1.0], [1.0, -2.0]), FACE);
    assert_intersects(false, along([3.0, 2.0], [2.0, 3.0]), FACE);
}

#[test]
fn an_edge_without_length_is_a_point() {
    let at = |p: Point| [p, p];
    assert_intersects(true, at([1.0, 1.0, 0.0]), FACE);
    assert_intersects(true, at([2.0, 2.0, 0.0]), FACE);
    assert_intersects(false, at([3.0, 2.0, 0.0]), FACE);
    assert_intersects(false, at([1.0, 1.0, 1.0]), FACE);
}

#[test]
fn a_face_without_area_is_a_segment_or_a_point() {
    let segment = [[0.0, 0.0, 0.0], [4.0, 4.0, 4.0], [1.0, 1.0, 1.0]];
    assert_intersects(true, [[3.0, 2.0, 3.0], [3.0, 4.0, 3.0]], segment);
    assert_intersects(true, [[2.0, 2.0, 2.0], [2.0, 2.0, 2.0]], segment);
    assert_intersects(true, [[4.0, 4.0, 4.0], [5.0, 5.0, 5.0]], segment);
    assert_intersects(false, [[5.0, 5.0, 5.0], [6.0, 6.0, 6.0]], segment);
    assert_intersects(false, [[3.0, 2.0, 3.0], [3.0, 4.0, 4.0]], segment);
    let point = [[1.0, 2.0, 3.0]; 3];
    assert_intersects(true, [[0.0, 2.0, 3.0], [2.0, 2.0, 3.0]], point);
    assert_intersects(true, [[1.0, 2.0, 3.0]; 2], point);
    assert_intersects(false, [[0.0, 2.0, 3.0], [2.0, 2.0, 4.0]], point);
}

#[test]
fn numbers_that_are_not_finite_are_named() {
    let error = |point, axis, value| {
        Err(NonFinite {
            time: None,
            point,
            axis,
            value,
        })
    };
    let end = [0.0, f64::INFINITY, 0.0];
    assert_eq!(
        EdgeFace::new([[0.0; 3], end], FACE).map(drop),
        error(1, Axis::Y, f64::INFINITY)
    );
    let [v1, v2, _] = FACE;
    let face = [v1, v2, [0.0, 0.0, f64::NEG_INFINITY]];
    assert_eq!(
        EdgeFace::new([v1, v2], face).map(drop),
        error(4, Axis::Z, f64::NEG_INFINITY)
    );
    let oriented = orient3d([v1, v2, end, v1]).map(drop);
    assert_eq!(oriented, error(2, Axis::Y, f64::INFINITY));
    assert_eq!(
        oriented.unwrap_err().to_string(),
        "coordinate y of point 2 is inf, not a finite number"
    );
}
