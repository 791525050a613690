//! Split vertices: several in one place, as exporters write them, and the welding of them.

use exact_ccd_mesh::Frame;

use crate::folder::Folder;
use crate::meshes::{obj, ply, tip_above_square};
use crate::scenes::note;

/// A flat square of two faces, split at the common edge, and a triangle that touches it in one corner.
fn split(z: f64) -> String {
    let [a, b, c, d] = [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z], [1.0, 1.0, z]];
    obj(&Frame::new(vec![a, b, c, c, b, d], vec![[0, 1, 2], [3, 4, 5]]).unwrap())
}

#[test]
fn split_vertices_are_noted_and_welded_on_request() {
    let folder = Folder::new();
    folder.write("start.obj", split(0.0));
    folder.write("end.obj", split(1.0));
    for command in [
        &["step", "start.obj", "end.obj"][..],
        &["step", "start.obj", "end.obj", "--toi"],
        &["audit", "start.obj", "end.obj", "--as-given"],
    ] {
        let run = folder.run(command);
        assert_eq!(run.status, 1, "{run:?}");
        let note = note(&run);
        assert!(
            note.starts_with("exact-ccd: note: ") && note.contains("--weld"),
            "{run:?}"
        );
        let run = folder.run(&[command, &["--weld"]].concat());
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{run:?}");
        assert!(
            run.stdout
                .starts_with("read: 4 vertices, 5 edges, 2 faces, 1 component\n"),
            "{run:?}"
        );
    }
    // --any names no pair that the note could be about.
    let run = folder.run(&["step", "start.obj", "end.obj", "--any"]);
    assert_eq!((run.status, run.stderr.as_str()), (1, ""));
    // A real contact at the start is not split vertices.
    folder.write("touching.ply", ply(&tip_above_square(0.0)));
    let run = folder.run(&["step", "touching.ply", "touching.ply"]);
    assert_eq!((run.status, run.stderr.as_str()), (1, ""));
}

/// The note is about the pair that is reported, whatever else touches; and vertices that move apart are not
/// split ones, which are in the same place in all frames.
#[test]
fn the_note_is_about_the_reported_pair() {
    let folder = Folder::new();
    // Two faces with a seam, and a triangle far away whose tip touches the second one of two others.
    let mesh = |height: f64, apart: f64| {
        let mut positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        positions.extend([
            [0.0, 1.0 + apart, 0.0],
            [1.0 + apart, 0.0, 0.0],
            [1.0 + apart, 1.0 + apart, 0.0],
        ]);
        let far = tip_above_square(height);
        positions.extend(far.positions.iter().map(|[x, y, z]| [x + 9.0, *y, *z]));
        let mut faces = vec![[0, 1, 2], [4, 5, 3]];
        faces.extend(far.mesh.faces().iter().map(|face| face.map(|vertex| vertex + 6)));
        obj(&Frame::new(positions, faces).unwrap())
    };
    folder.write("start.obj", mesh(0.0, 0.0));
    folder.write("end.obj", mesh(1.0, 0.0));
    folder.write("apart.obj", mesh(1.0, 0.5));
    for option in [&[][..], &["--toi"]] {
        let run = folder.run(&[&["step", "start.obj", "end.obj"], option].concat());
        assert!(
            run.stdout.contains("contact at t = 0: vertex 1 and face 1 "),
            "{run:?}"
        );
        assert!(note(&run).contains("--weld"), "{run:?}");
        let run = folder.run(&[&["step", "start.obj", "apart.obj"], option].concat());
        assert!(
            run.stdout.contains("contact at t = 0: vertex 1 and face 1 "),
            "{run:?}"
        );
        assert_eq!(run.stderr, "", "{run:?}");
    }
}

/// Rods meet no face: the pair that touches at the start is a contact.
#[test]
fn an_audit_of_rods_has_the_note_in_every_mode() {
    let folder = Folder::new();
    for (name, z) in [("start.obj", 0.0), ("end.obj", 1.0)] {
        let rod = format!("v 0 0 {z}\nv 1 0 {z}\n");
        folder.write(name, format!("{rod}{rod}l 1 2\nl 3 4\n"));
    }
    let audit = ["audit", "start.obj", "end.obj", "--as-given"];
    for option in [&[][..], &["--all", "all.csv"]] {
        let run = folder.run(&[&audit[..], option].concat());
        let pair = "contact in frame 0 (start.obj): edge 0 ";
        assert!(run.stdout.contains(pair), "{run:?}");
        assert!(note(&run).contains("--weld"), "{run:?}");
    }
    let rows = folder.read("all.csv");
    let of_frame = rows.lines().filter(|row| row.starts_with("0,"));
    assert_eq!(of_frame.count(), 1, "{rows}");
}

/// Vertices of two parts in one place stay apart, with --weld too, and so do loose vertices of one part.
#[test]
fn the_note_names_weld_only_where_it_joins() {
    let folder = Folder::new();
    let triangle = |z: f64, corner: [f64; 3]| {
        let positions = vec![[0.0, 0.0, z], corner, [0.0, 1.0, z]];
        obj(&Frame::new(positions, vec![[0, 1, 2]]).unwrap())
    };
    for (time, z) in [("start", 0.0), ("end", 1.0)] {
        folder.write(&format!("a-{time}.obj"), triangle(z, [1.0, 0.0, z]));
        folder.write(&format!("b-{time}.obj"), triangle(z, [-1.0, 0.0, z]));
        folder.write(
            &format!("points-{time}.obj"),
            format!("v 0 0 {z}\nv 0 0 {z}\np 1 2\n"),
        );
    }
    let parts = ["step", "a=a-start.obj", "a-end.obj", "b=b-start.obj", "b-end.obj"];
    for weld in [&[][..], &["--weld"]] {
        let run = folder.run(&[&parts, weld].concat());
        assert_eq!(run.status, 1, "{run:?}");
        assert_eq!(
            note(&run),
            "exact-ccd: note: the first pair that touches at the start has vertices in the same place, of the parts a and \
             b, which --weld does not join; write them to one file, or leave their pairs out with --ignore a:b"
        );
    }
    let points = [
        "step",
        "points-start.obj",
        "points-end.obj",
        "--min-distance",
        "0.5",
        "--no-seconds",
        "--points",
    ];
    let run = folder.run(&points);
    assert_eq!((run.status, run.stderr.as_str()), (1, ""), "{run:?}");
    assert_eq!(folder.run(&[&points[..], &["--weld"]].concat()), run);
}

#[test]
fn welding_keeps_bodies_that_touch_in_a_point_apart() {
    let folder = Folder::new();
    let corner = |z: f64| {
        let positions = vec![
            [0.0, 0.0, z],
            [1.0, 0.0, z],
            [0.0, 1.0, z],
            [0.0, 0.0, z],
            [-1.0, 0.0, z],
            [0.0, -1.0, z],
        ];
        obj(&Frame::new(positions, vec![[0, 1, 2], [3, 4, 5]]).unwrap())
    };
    folder.write("start.obj", corner(0.0));
    folder.write("end.obj", corner(1.0));
    let run = folder.run(&["step", "start.obj", "end.obj", "--weld"]);
    assert_eq!(run.status, 1);
    assert!(run.stdout.starts_with("read: 6 vertices"), "{run:?}");
}
