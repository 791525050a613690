//! The output of `exact-ccd round` for meshes.

use exact_ccd_files::read_frame;
use exact_ccd_mesh::Frame;
use exact_ccd_methods::parity::Displacement;

use crate::folder::Folder;
use crate::meshes::{obj, off, ply, stl, tip_above_square};
use crate::rounding_report::{Report, assert_drawn};

/// The rounding errors of these frames. The displacement in the report is checked first.
fn errors(frames: &[&Frame], report: &Report) -> Vec<f64> {
    let bounds = frames
        .iter()
        .map(|frame| frame.bounds())
        .reduce(|a, b| a.union(&b))
        .unwrap();
    let displacement = Displacement::of_box(bounds.lower, bounds.upper);
    assert_eq!(report.displacement, displacement.along_axes());
    let points = frames.iter().flat_map(|frame| &frame.positions);
    points.flat_map(|&point| displacement.error(point)).collect()
}

/// The frame, with each vertex moved and rounded.
fn shifted(frame: &Frame, displacement: [f64; 3]) -> Frame {
    let mut shifted = frame.clone();
    for point in &mut shifted.positions {
        *point = [0, 1, 2].map(|axis: usize| point[axis] + displacement[axis]);
    }
    shifted
}

#[test]
fn one_mesh_becomes_one_file() {
    let frame = tip_above_square(-0.1);
    let folder = Folder::new();
    for (name, contents) in [
        ("mesh.ply", ply(&frame)),
        ("mesh.obj", obj(&frame).into()),
        ("mesh.off", off(&frame).into()),
    ] {
        folder.write(name, contents);
        let run = folder.run(&["round", name, "--output", "rounded.ply", "--plot", "plot.svg"]);
        let report = Report::of(&run);
        report.assert_counts(&errors(&[&frame], &report));
        assert_drawn(&folder.read("plot.svg"), &report.rows);
        let rounded = read_frame(folder.path("rounded.ply")).unwrap();
        assert_eq!(rounded, shifted(&frame, report.displacement), "{name}");
    }
}

#[test]
fn several_frames_are_moved_by_the_displacement_of_the_box_around_them() {
    let [start, middle, end] = [0.7, 0.1, -1e-9].map(tip_above_square);
    let folder = Folder::new();
    folder.write("start.ply", ply(&start));
    folder.write("middle.off", off(&middle));
    folder.write("end.obj", obj(&end));
    // The folder is created.
    let run = folder.run(&[
        "round",
        "start.ply",
        "middle.off",
        "end.obj",
        "--output",
        "new/rounded",
    ]);
    let report = Report::of(&run);
    report.assert_counts(&errors(&[&start, &middle, &end], &report));
    let read = |name: &str| read_frame(folder.path("new/rounded").join(name)).unwrap();
    // The box of the first and the last frame contains all three.
    let bounds = start.bounds().union(&end.bounds());
    let displacement = Displacement::of_box(bounds.lower, bounds.upper).along_axes();
    assert_eq!(read("start.ply"), shifted(&start, displacement));
    assert_eq!(read("middle.ply"), shifted(&middle, displacement));
    assert_eq!(read("end.ply"), shifted(&end, displacement));
}

#[test]
fn stl_has_no_shared_vertices() {
    let folder = Folder::new();
    folder.write("mesh.stl", stl(&tip_above_square(-0.5)));
    let soup = read_frame(folder.path("mesh.stl")).unwrap();
    let report = Report::of(&folder.run(&["round", "mesh.stl", "--output", "rounded.ply"]));
    report.assert_counts(&errors(&[&soup], &report));
    assert_eq!(read_frame(folder.path("rounded.ply")).unwrap().mesh, soup.mesh);
}

#[test]
fn a_mesh_can_take_the_place_of_its_input() {
    let folder = Folder::new();
    folder.write("mesh.ply", ply(&tip_above_square(-0.1)));
    let round = || Report::of(&folder.run(&["round", "mesh.ply", "--output", "mesh.ply"]));
    assert_ne!(round().displacement, [0.0; 3]);
    assert_eq!(round().displacement, [0.0; 3]);
}
