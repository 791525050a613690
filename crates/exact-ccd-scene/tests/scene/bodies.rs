//! Rods and particles in scene files, generated and from mesh files.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use exact_ccd_files::{UnstructuredGrid, write_ply, write_vtu};
use exact_ccd_mesh::Frame;
use exact_ccd_scene::Scene;

use crate::{filter, parse};

const ROD: &str = "rod = { density = 1000.0, young = 1e6, radius = 0.01 }";
const BEADS: &str = "particles = { density = 1000.0, radius = 0.01 }";

fn body(lines: &[&str]) -> String {
    format!("duration = 0.1\n\n[[body]]\n{}\n", lines.join("\n"))
}

/// The scene of a body with a mesh in a file of a folder.
fn of_file(folder: &Path, file: &str, material: &str) -> Result<Scene, String> {
    let text = body(&[&format!("mesh = \"{file}\""), material]);
    Scene::parse(&text, &folder.join("scene.toml"), None, &filter).map_err(|error| error.to_string())
}

fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn rods_and_particles_are_generated() {
    let line = "shape = { line = { edges = 4, length = 2.0 } }";
    let scene = parse(&body(&[line, ROD, "offset = 0.05"])).unwrap();
    assert_eq!(scene.simulation.system().start()[4], [2.0, 0.0, 0.0]);
    assert_eq!(scene.simulation.system().surface().loose_edges().len(), 4);
    assert_eq!(scene.simulation.system().surface_offsets(), [0.05; 5]);
    let points = "shape = { points = { counts = [2, 1, 3], size = [1.0, 9.0, 4.0] } }";
    let mut scene = parse(&body(&[points, BEADS])).unwrap();
    assert_eq!(scene.simulation.system().particles(), [0, 1, 2, 3, 4, 5]);
    assert_eq!(scene.simulation.system().start()[5], [1.0, 0.0, 4.0]);
    scene.simulation.step().unwrap();
}

/// The knot has edges of one length, up to the corners that they cut, and clearance for a thickness.
#[test]
fn a_knot_is_a_rod_with_clearance() {
    let shape = "shape = { knot = { edges = 64, length = 1.8 } }";
    let scene = parse(&body(&[shape, ROD, "offset = 0.012"])).unwrap();
    let points = scene.simulation.system().start();
    let lengths = points.windows(2).map(|ends| {
        (0..3)
            .map(|axis| (ends[1][axis] - ends[0][axis]).powi(2))
            .sum::<f64>()
            .sqrt()
    });
    for length in lengths {
        assert!((0.98..1.0001).contains(&(length / (1.8 / 64.0))), "{length}");
    }
    // Both ends are below, on both sides.
    let lowest = points.iter().map(|point| point[1]).fold(f64::INFINITY, f64::min);
    assert!(points[0][1] == lowest && points[64][1] - lowest < 1e-12);
    assert!(points[0][0] > 0.05 && points[64][0] < -0.05);
}

/// The same rod and the same particles, in every format that has edges and points.
#[test]
fn rods_and_particles_are_read_from_files() {
    let folder = folder("rods");
    let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [2.0, 1.0, 0.0]];
    let rod = Frame::with_edges(positions.clone(), Vec::new(), &[[0, 1], [1, 2]]).unwrap();
    let beads = Frame::with_edges(positions, Vec::new(), &[]).unwrap();
    let vertices = "v 0 0 0\nv 1 0 0\nv 2 1 0\n";
    fs::write(folder.join("rod.obj"), format!("{vertices}l 1 2 3\n")).unwrap();
    fs::write(folder.join("beads.obj"), format!("{vertices}p 1 2 3\n")).unwrap();
    for (name, frame) in [("rod", &rod), ("beads", &beads)] {
        let create = |extension: &str| File::create(folder.join(format!("{name}.{extension}"))).unwrap();
        write_ply(create("ply"), frame).unwrap();
        let grid = UnstructuredGrid {
            points: if name == "beads" { &[0, 1, 2] } else { &[] },
            ..frame.into()
        };
        write_vtu(create("vtu"), grid).unwrap();
    }
    for extension in ["obj", "ply", "vtu"] {
        let scene = of_file(&folder, &format!("rod.{extension}"), ROD).unwrap();
        assert_eq!(
            scene.simulation.system().surface().loose_edges(),
            [[0, 1], [1, 2]],
            "{extension}"
        );
        let scene = of_file(&folder, &format!("beads.{extension}"), BEADS).unwrap();
        assert_eq!(scene.simulation.system().particles(), [0, 1, 2], "{extension}");
        // A body must have the cells of its material.
        let error = of_file(&folder, &format!("beads.{extension}"), ROD).unwrap_err();
        assert!(
            error.contains("body[0].rod: the mesh of the rod has no edges"),
            "{error}"
        );
        let error = of_file(&folder, &format!("rod.{extension}"), BEADS).unwrap_err();
        assert!(
            error.contains("the mesh of the particles has faces or edges"),
            "{error}"
        );
    }
}

#[test]
fn errors_of_rods_and_particles_name_their_field() {
    let line = "shape = { line = { edges = 4, length = 2.0 } }";
    let cases = [
        (
            vec!["shape = { line = { edges = 0, length = 2.0 } }", ROD],
            "body[0].shape: the shape has 0 edges, expected 1 to 1048576",
        ),
        (
            vec![line, "rod = { density = 1.0, young = 1.0, radius = 0.0 }"],
            "body[0].rod.radius: `radius` is 0, expected a positive number",
        ),
        (
            vec![line, "rod = { density = 1.0, young = -1.0, radius = 1.0 }"],
            "body[0].rod.young: `young` is -1, expected a positive number",
        ),
        (
            vec![line, ROD, "offset = -1.0"],
            "body[0].offset: `offset` is -1, expected a number from 0 to 8.98",
        ),
        (
            vec![line, ROD, BEADS],
            "body[0].particles: the body has both `rod` and `particles`, expected at most one material",
        ),
        (
            vec!["shape = { sphere = { subdivisions = 0, radius = 1.0 } }", ROD],
            "body[0].rod: the mesh of the rod has faces, expected edges only",
        ),
        (
            vec![line, ROD, "offset = 0.3"],
            "edge [0, 1] of body[0] and edge [2, 3] of body[0] are within the sum of their offsets, 0.6 m, at the start",
        ),
    ];
    for (lines, expected) in cases {
        let error = parse(&body(&lines)).err().unwrap();
        assert!(error.contains(expected), "{error}, expected {expected}");
    }
    // Methods that are not exact have no minimum separation.
    let text = body(&[line, ROD, "offset = 0.05"]).replace("\n\n", "\nsettings = { ccd = \"parity\" }\n\n");
    let error = parse(&text).err().unwrap();
    assert!(
        error.contains("settings.ccd: the CCD method `parity` has no minimum separation"),
        "{error}"
    );
}

#[test]
fn facts_about_mesh_files_are_notes() {
    let folder = folder("scene-notes");
    fs::write(folder.join("plane.obj"), "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n").unwrap();
    let scene = of_file(&folder, "plane.obj", "").unwrap();
    let [note] = &scene.notes[..] else {
        panic!("{:?}", scene.notes)
    };
    assert!(
        note.contains("plane.obj: line 1: the vertices have two coordinates"),
        "{note}"
    );
}
