//! Meshes that are written in single precision, and contacts that its rounding makes.

use exact_ccd_mesh::{Frame, Precision};

use crate::folder::Folder;
use crate::meshes::{obj, ply, tip_above_square};

/// The tip above the square, with all coordinates moved up by a number.
fn at(height: f64, offset: f64) -> Frame {
    let mut frame = tip_above_square(height);
    for position in &mut frame.positions {
        *position = position.map(|x| x + offset);
    }
    frame
}

fn single(frame: &Frame) -> Frame {
    let mut frame = frame.clone();
    for position in &mut frame.positions {
        *position = Precision::Single.round(*position);
    }
    frame
}

#[test]
fn a_mesh_that_stays_free_in_single_precision() {
    let folder = Folder::new();
    folder.write("mesh.obj", obj(&at(0.001, 1000.1)));
    let run = folder.run(&["step", "mesh.obj", "--write-f32", "--no-seconds"]);
    assert_eq!(run.status, 0, "{}", run.stdout);
    assert!(run.stdout.contains("\nfree of contact\n"), "{}", run.stdout);
    let note = "the end of the step is the mesh in single precision: 7 of 7 vertices move, by at most ";
    assert!(run.stderr.contains(note), "{}", run.stderr);
}

/// The gap is shorter than the distance of two `f32` there.
#[test]
fn a_mesh_that_touches_itself_in_single_precision_is_named_with_the_place() {
    let folder = Folder::new();
    let mesh = at(1e-6, 1000.1);
    folder.write("mesh.obj", obj(&mesh));
    let run = folder.run(&["step", "mesh.obj", "--write-f32", "--no-seconds"]);
    assert_eq!(run.status, 1, "{}", run.stdout);
    assert!(
        run.stdout.contains(": vertex 4 and face 1 (vertices 2, 1, 3)\n"),
        "{}",
        run.stdout
    );
    // So does the mesh that is read from such a file.
    folder.write("written.ply", ply(&single(&mesh)));
    let run = folder.run(&["audit", "written.ply"]);
    assert_eq!(run.status, 1, "{}", run.stdout);
}

#[test]
fn several_meshes_are_parts_and_wrong_arguments_are_errors() {
    let folder = Folder::new();
    folder.write("a.obj", obj(&at(0.5, 0.1)));
    folder.write("b.obj", obj(&at(0.5, 100.1)));
    let run = folder.run(&["step", "a.obj", "b.obj", "--write-f32"]);
    assert!(
        run.status == 0 && run.stdout.contains("part b: "),
        "{}",
        run.stdout
    );
    folder.write("huge.obj", "v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n");
    for (arguments, message) in [
        (
            &["step", "huge.obj", "--write-f32"][..],
            "vertex 1 of the mesh has a coordinate beyond the range",
        ),
        (
            &["step", "a.obj", "--write-f32", "--certificate", "proof"],
            "cannot be used with",
        ),
    ] {
        let run = folder.run(arguments);
        assert!(run.status == 2 && run.stderr.contains(message), "{}", run.stderr);
    }
}

/// Frames in single precision whose contact is shallower than a unit in the last place, deeper ones, and ones
/// in double precision.
#[test]
fn a_contact_that_rounding_alone_may_have_made_has_a_note() {
    let words = "touch only because of rounding, perhaps: the positions are in single precision";
    for (heights, is_single, is_noted) in [
        ([1.0, -1e-5], true, true),
        ([1.0, 1e-6], true, true),
        ([1.0, -0.5], true, false),
        ([1.0, -1e-9], false, false),
    ] {
        let folder = Folder::new();
        let write = |name: &str, height: f64| {
            let frame = at(height, 1000.1);
            folder.write(name, ply(&if is_single { single(&frame) } else { frame }));
        };
        write("0.ply", heights[0]);
        write("1.ply", heights[1]);
        for command in ["step", "audit"] {
            let run = folder.run(&[command, "0.ply", "1.ply", "--json"]);
            assert_eq!(run.status, 1, "{heights:?} {}", run.stdout);
            assert_eq!(run.stderr.contains(words), is_noted, "{heights:?} {}", run.stderr);
            assert_eq!(run.stdout.contains(words), is_noted);
        }
    }
    // Short numbers, as of models, are not rounded.
    let folder = Folder::new();
    folder.write("0.ply", ply(&tip_above_square(1.0)));
    folder.write("1.ply", ply(&tip_above_square(0.0)));
    assert_eq!(folder.run(&["step", "0.ply", "1.ply"]).stderr, "");
}
