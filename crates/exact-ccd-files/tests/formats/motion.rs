//! Motions and frames from files.

use std::path::{Path, PathBuf};

use super::temporary;
use exact_ccd_files::{Format, parse_frame, read_frame, read_motion, write_ply};
use exact_ccd_mesh::{Frame, Point};

const TRIANGLE: [Point; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn triangle() -> Frame {
    Frame::new(TRIANGLE.to_vec(), vec![[0, 1, 2]]).unwrap()
}

/// Writes a file for one test and returns its path.
fn file(name: &str, contents: &str) -> PathBuf {
    temporary(&format!("motion/{name}"), contents)
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
    let motion = read_motion(start, end).unwrap();
    assert_eq!(motion.mesh.faces(), [[0, 1, 2]]);
    assert_eq!(motion.x0, TRIANGLE);
    assert_eq!(motion.x1, TRIANGLE.map(|[x, y, _]| [x, y, 1.0]));
}

#[test]
fn errors_name_the_files() {
    let good = file("good.off", "OFF\n3 1 0\n0 0 1\n1 0 1\n0 1 1\n3 0 1 2\n");
    let turned = file("turned.off", "OFF\n3 1 0\n0 0 1\n1 0 1\n0 1 1\n3 1 2 0\n");
    let bad = file("bad.off", "OFF\n3 1 0\n0 0 1\n1 0 nan\n0 1 1\n3 0 1 2\n");
    let missing = good.with_file_name("missing.ply");
    let unknown = good.with_file_name("mesh.unknown");
    let message = |start: &Path, end: &Path| read_motion(start, end).unwrap_err().to_string();

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
        format!("{}: line 4: expected a finite number, found `nan`", bad.display()),
    );
    assert!(message(&missing, &good).starts_with(&format!("{}: ", missing.display())));
    assert_eq!(
        message(&good, &unknown),
        format!(
            "{}: unknown extension, expected .ply, .obj, .stl, .off, .msh, .vtu, .vtp, .vtk, \
             .glb, .gltf, .npy or .npz, also with .gz",
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
    let motion = read_motion(start, end).unwrap();
    // The two copies of b coincide at the start only, so both are kept.
    assert_eq!(motion.mesh.faces(), [[0, 1, 2], [2, 3, 0]]);
    assert_eq!(motion.x0, [a, b, c, b]);
    assert_eq!(motion.x1, [up(a), up(b), up(c), b]);
}

#[test]
fn a_frame_that_would_not_read_back_is_not_written() {
    let mut unsound = triangle();
    unsound.positions[2][0] = f64::INFINITY;
    let mut bytes = Vec::new();
    let error = write_ply(&mut bytes, &unsound).unwrap_err();
    assert_eq!(error.kind(), std::io::ErrorKind::InvalidInput);
    assert_eq!(
        error.to_string(),
        "vertex 2 has x = inf, expected a finite number"
    );
    assert!(bytes.is_empty());
}

#[test]
fn a_written_file_reads_back() {
    let path = file("written.ply", "");
    let written = triangle();
    write_ply(std::fs::File::create(&path).unwrap(), &written).unwrap();
    assert_eq!(read_frame(&path).unwrap(), written);
    assert_eq!(
        parse_frame(&std::fs::read(&path).unwrap(), Format::Ply).unwrap(),
        written
    );
}
