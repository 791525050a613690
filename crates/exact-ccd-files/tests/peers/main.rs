//! Files that trimesh, meshio, pyvista and numpy write, read as the same motion.
//!
//! `write.py` writes them, with the Python of the environment variable `EXACT_CCD_PYTHON`, or
//! `python3`. `scripts/check peers` runs the test, which is ignored elsewhere, with all packages that it
//! needs.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::path::{Path, PathBuf};
use std::process::Command;

use exact_ccd_files::{Contents, FrameSequence, MeshFile, Polygons, read_motion};
use exact_ccd_mesh::{Frame, Point, step};

/// The faces of a frame as positions, each from its least corner on: vertices may be numbered in
/// any way.
fn triangles(frame: &Frame) -> Vec<[Point; 3]> {
    let mut triangles: Vec<_> = frame.mesh.faces().to_vec();
    triangles.dedup();
    let mut triangles: Vec<[Point; 3]> = triangles
        .into_iter()
        .map(|face| {
            let mut corners = face.map(|vertex| frame.positions[vertex as usize]);
            corners.sort_by(|a, b| a.partial_cmp(b).unwrap());
            corners
        })
        .collect();
    triangles.sort_by(|a, b| a.partial_cmp(b).unwrap());
    triangles
}

/// The files of one line of the list: the kind, then paths.
fn written(folder: &Path) -> Vec<(String, Vec<PathBuf>)> {
    let python = std::env::var_os("EXACT_CCD_PYTHON").unwrap_or("python3".into());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/peers/write.py");
    let _ = std::fs::remove_dir_all(folder);
    std::fs::create_dir_all(folder).unwrap();
    let output = Command::new(python).arg(script).arg(folder).output();
    let output = output.expect("there is no Python: set EXACT_CCD_PYTHON");
    let errors = String::from_utf8_lossy(&output.stderr);
    let packages = "pip install trimesh meshio pyvista scipy";
    assert_ne!(output.status.code(), Some(3), "{} ({packages})", errors.trim());
    assert!(output.status.success(), "{errors}");
    let list = String::from_utf8(output.stdout).unwrap();
    let line = |line: &str| {
        let mut words = line.split_whitespace();
        let kind = words.next().unwrap().to_owned();
        (kind, words.map(|name| folder.join(name)).collect())
    };
    list.lines().map(line).collect()
}

/// Both frames in one file are the expected ones.
fn assert_frames(path: &Path, expected: &[(Vec<[Point; 3]>, Contents); 2]) {
    let sequence = FrameSequence::open(path, Polygons::Refuse).unwrap();
    assert_eq!(sequence.len(), 2, "{}", sequence.name(0));
    for (frame, (expected, _)) in sequence.iter().zip(expected) {
        assert_eq!(
            &triangles(&frame.unwrap().frame),
            expected,
            "{}",
            sequence.name(0)
        );
    }
}

#[test]
#[ignore = "needs Python with trimesh, meshio, pyvista and scipy: run scripts/check peers"]
fn all_tools_write_the_same_motion() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("peers");
    let list = written(&folder);
    assert_eq!(list.len(), 105);
    let reference = ["meshio.0.vtu", "meshio.1.vtu"].map(|name| folder.join(name));
    let surface = |path: &PathBuf| {
        let file = MeshFile::read(path, Polygons::default());
        let file = file.unwrap_or_else(|error| panic!("{error}"));
        (triangles(&file.frame), file.contents)
    };
    let expected = reference.each_ref().map(surface);
    assert_eq!(expected[0].1.polygons, 8);
    for (kind, paths) in list {
        if kind == "frames" {
            assert_frames(&paths[0], &expected);
            continue;
        }
        let shown = paths[0].display();
        for (path, (expected, _)) in paths.iter().zip(&expected) {
            let (found, contents) = surface(path);
            let (polygons, solids) = match kind.as_str() {
                "polygons" => (8, 0),
                "solids" => (16, 3),
                _ => (0, 0),
            };
            assert_eq!(
                (contents.polygons, contents.solids),
                (polygons, solids),
                "{shown}"
            );
            match kind.as_str() {
                "solids" => assert_eq!((contents.faces, contents.components), (32, 2), "{shown}"),
                _ => assert_eq!(&found, expected, "{shown}"),
            }
        }
        let motion = read_motion(&paths[0], &paths[1]).unwrap();
        let report = step(&motion.mesh, &motion.x0, &motion.x1).unwrap();
        assert_eq!(report.time_of_impact(), Some(0.5), "{shown}");
    }
}
