//! Two frames as the start and the end of one motion.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::path::{Path, PathBuf};

use exact_ccd_mesh::{Format, Frame, Motion, Point};

const TRIANGLE: [Point; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn frame(positions: &[Point], faces: &[[u32; 3]]) -> Frame {
    Frame::new(positions.to_vec(), faces.to_vec()).unwrap()
}

/// Writes a file for one test and gives its path.
fn file(name: &str, contents: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, contents).unwrap();
    path
}

fn stl(facets: &[[Point; 3]]) -> String {
    let vertex = |[x, y, z]: &Point| format!("vertex {x} {y} {z}\n");
    let facet = |corners: &[Point; 3]| {
        let vertices: String = corners.iter().map(vertex).collect();
        format!("facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n")
    };
    format!(
        "solid\n{}endsolid\n",
        facets.iter().map(facet).collect::<String>()
    )
}

#[test]
fn two_files_are_one_motion() {
    let start = file("start.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let end = file("end.off", "OFF\n3 1 0\n0 0 1\n1 0 1\n0 1 1\n3 0 1 2\n");
    let motion = Motion::read(start, end).unwrap();
    assert_eq!(motion.mesh.faces(), [[0, 1, 2]]);
    assert_eq!(motion.x0, TRIANGLE);
    assert_eq!(motion.x1, TRIANGLE.map(|[x, y, _]| [x, y, 1.0]));
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
fn errors_name_the_files() {
    let good = file("good.off", "OFF\n3 1 0\n0 0 1\n1 0 1\n0 1 1\n3 0 1 2\n");
    let turned = file("turned.off", "OFF\n3 1 0\n0 0 1\n1 0 1\n0 1 1\n3 1 2 0\n");
    let bad = file("bad.off", "OFF\n3 1 0\n0 0 1\n1 0 nan\n0 1 1\n3 0 1 2\n");
    let missing = good.with_file_name("missing.ply");
    let unknown = good.with_file_name("mesh.vtk");
    let message = |start: &Path, end: &Path| Motion::read(start, end).unwrap_err().to_string();

    let (good_name, turned_name) = (good.display(), turned.display());
    assert_eq!(
        message(&good, &turned),
        format!(
            "{good_name} and {turned_name}: face 0 is [0, 1, 2] at the start and [1, 2, 0] at the end, \
             expected the same mesh"
        ),
    );
    assert_eq!(
        message(&good, &bad),
        format!(
            "{}: vertex 1 has z = NaN, expected a finite number",
            bad.display()
        ),
    );
    assert!(message(&missing, &good).starts_with(&format!("{}: ", missing.display())));
    assert_eq!(
        message(&good, &unknown),
        format!(
            "{}: unknown extension, expected .ply, .obj, .stl, .off, .msh or .vtu",
            unknown.display()
        ),
    );
}

#[test]
fn a_pair_of_stl_files_is_welded() {
    let [a, b, c] = TRIANGLE;
    let up = |[x, y, _]: Point| [x, y, 1.0];
    let start = file("start.stl", &stl(&[[a, b, c], [c, b, [-0.0, 0.0, -0.0]]]));
    let end = file("end.STL", &stl(&[[up(a), up(b), up(c)], [up(c), b, up(a)]]));
    let motion = Motion::read(start, end).unwrap();
    // b meets b at the start only: there are two of them.
    assert_eq!(motion.mesh.faces(), [[0, 1, 2], [2, 3, 0]]);
    assert_eq!(motion.x0, [a, b, c, b]);
    assert_eq!(motion.x1, [up(a), up(b), up(c), b]);
}

#[test]
fn welding_keeps_what_moves_apart() {
    let soup = |positions: &[Point]| frame(positions, &[[0, 1, 2]]);
    let [a, b, c] = TRIANGLE;
    let weld = |start, end| Motion::weld(start, end).unwrap();
    assert_eq!(weld(soup(&[a, b, b]), soup(&[a, b, c])).mesh.faces(), [[0, 1, 2]]);
    let collapsed = weld(soup(&[a, b, b]), soup(&[a, c, c]));
    assert_eq!(collapsed.mesh.faces(), [[0, 1, 1]]);
    assert_eq!(collapsed.mesh.edges(), [[0, 1]]);
    assert_eq!(collapsed.mesh.vertex_count(), 2);
    assert!(Motion::weld(soup(&[a, b, c]), frame(&[a, b, c], &[])).is_err());
}

#[test]
fn a_frame_refuses_what_it_cannot_hold() {
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

#[test]
fn a_frame_that_would_not_read_back_is_not_written() {
    let mut unsound = frame(&TRIANGLE, &[[0, 1, 2]]);
    unsound.positions[2][0] = f64::INFINITY;
    let mut bytes = Vec::new();
    let error = unsound.write_ply(&mut bytes).unwrap_err();
    assert_eq!(error.kind(), std::io::ErrorKind::InvalidInput);
    assert_eq!(
        error.to_string(),
        "vertex 2 has x = inf, expected a finite number"
    );
    assert!(bytes.is_empty());
}

#[test]
fn a_written_file_reads_back() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("written.ply");
    let written = frame(&TRIANGLE, &[[0, 1, 2]]);
    written.write_ply(std::fs::File::create(&path).unwrap()).unwrap();
    assert_eq!(Frame::read(&path).unwrap(), written);
    assert_eq!(
        Frame::parse(&std::fs::read(&path).unwrap(), Format::Ply).unwrap(),
        written
    );
}
