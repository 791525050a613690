//! Two frames as the start and the end of one motion.

use exact_ccd_mesh::{Frame, Motion, MotionError, Point};

const TRIANGLE: [Point; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn frame(positions: &[Point], faces: &[[u32; 3]]) -> Frame {
    Frame::new(positions.to_vec(), faces.to_vec()).unwrap()
}

#[track_caller]
fn assert_mismatch(start: Frame, end: Frame, message: &str) {
    assert_eq!(Motion::new(start, end).unwrap_err().to_string(), message);
}

#[test]
fn the_first_difference_is_named() {
    let start = || frame(&TRIANGLE, &[[0, 1, 2], [2, 1, 0]]);
    assert_mismatch(
        start(),
        frame(&TRIANGLE[..2], &[]),
        "3 vertices at the start, 2 at the end, expected the same mesh",
    );
    assert_mismatch(
        start(),
        frame(&TRIANGLE, &[[0, 1, 2]]),
        "2 faces at the start, 1 at the end, expected the same mesh",
    );
    assert_mismatch(
        start(),
        frame(&TRIANGLE, &[[0, 1, 2], [2, 0, 1], [0, 0, 0]]),
        "face 1 is [2, 1, 0] at the start and [2, 0, 1] at the end, expected the same mesh",
    );
    let mut unsound = start();
    unsound.positions[1][2] = f64::NAN;
    assert_mismatch(
        start(),
        unsound.clone(),
        "at the end, vertex 1 has z = NaN, expected a finite number",
    );
    unsound.positions.pop();
    assert_mismatch(
        unsound,
        start(),
        "at the start, 2 positions, expected one for each of 3 vertices",
    );
}

#[test]
fn welding_keeps_vertices_that_separate() {
    let soup = |positions: &[Point]| frame(positions, &[[0, 1, 2]]);
    let [a, b, c] = TRIANGLE;
    let weld = |start, end| Motion::weld(start, end).unwrap();
    assert_eq!(weld(soup(&[a, b, b]), soup(&[a, b, c])).mesh.faces(), [[0, 1, 2]]);
    // Vertices that come together are kept, too.
    assert_eq!(weld(soup(&[a, b, c]), soup(&[a, b, b])).mesh.faces(), [[0, 1, 2]]);
    let collapsed = weld(soup(&[a, b, b]), soup(&[a, c, c]));
    assert_eq!(collapsed.mesh.faces(), [[0, 1, 1]]);
    assert_eq!(collapsed.mesh.edges(), [[0, 1]]);
    assert_eq!(collapsed.mesh.vertex_count(), 2);
    assert!(Motion::weld(soup(&[a, b, c]), frame(&[a, b, c], &[])).is_err());
}

#[test]
fn invalid_frames_are_errors() {
    let error = |positions: &[Point], face| {
        Frame::new(positions.to_vec(), vec![face])
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        error(&TRIANGLE, [0, 1, 3]),
        "face 0 names vertex 3, but there are only 3 vertices"
    );
    let infinite = [[0.0, f64::INFINITY, 0.0]];
    assert_eq!(
        error(&infinite, [0, 0, 0]),
        "vertex 0 has y = inf, expected a finite number"
    );
}

/// Coordinates are compared as numbers, and not rounded.
#[test]
fn numbers_that_differ_are_not_welded() {
    let mut welding = exact_ccd_mesh::Welding::default();
    let tiny = f64::from_bits(1);
    welding.restrict(&[
        [0.0; 3],
        [-0.0; 3],
        [tiny, 0.0, 0.0],
        [2.0 * tiny, 0.0, 0.0],
        [1.0; 3],
    ]);
    assert_eq!(welding.first_vertices(), [0, 2, 3, 4]);
    let new = [0, 1, 2, 3, 4, 5].map(|vertex| welding.vertex_of(vertex));
    assert_eq!(new, [Some(0), Some(0), Some(1), Some(2), Some(3), None]);
    let mesh = frame(&TRIANGLE, &[[0, 1, 2]]).mesh;
    let other = MotionError::VertexCount { start: 5, end: 3 };
    assert_eq!(welding.mesh(&mesh), Err(other));
}
