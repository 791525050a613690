//! Parts: their names in contacts, faces alone, and vertices that are nearly in one place.

use serde_json::{Value, json};

use crate::folder::{Folder, Run};
use crate::scenes::note;
use crate::schema::Schema;
use crate::verdicts::cuboid;

fn json_of(run: &Run) -> Value {
    let report = serde_json::from_str(&run.stdout).unwrap();
    Schema::of_reports().assert("motion", &report);
    report
}

/// A box that moves into a spike at rest, whose tip is its vertex 3.
fn box_and_spike() -> Folder {
    let folder = Folder::new();
    folder.write("box0.obj", cuboid([1.0; 3], 0.0, -5.0));
    folder.write("box1.obj", cuboid([1.0; 3], 0.0, 1.0));
    folder.write(
        "spike.obj",
        "v 2 -1 -1\nv 2 1 -1\nv 2 0 1\nv 0 0.25 0.125\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n",
    );
    folder
}

#[test]
fn a_contact_names_its_parts_and_the_ids_in_their_files() {
    let folder = box_and_spike();
    let command = [
        "step",
        "box0.obj",
        "box1.obj",
        "--with",
        "spike.obj",
        "--all",
        "all.csv",
        "--view",
        "page.html",
    ];
    let run = folder.run(&command);
    assert!(
        run.stdout
            .contains(": spike: vertex 3 and box0: face 11 (vertices 3, 7, 5)\n"),
        "{run:?}"
    );
    assert!(
        run.stdout
            .contains("; ids count from 0, in the file of each part\n"),
        "{run:?}"
    );
    let list = folder.read("all.csv");
    let first = list.lines().nth(1).unwrap();
    assert!(
        list.lines()
            .next()
            .unwrap()
            .ends_with(",part_a,part_id_a,part_b,part_id_b"),
        "{list}"
    );
    assert!(
        first.starts_with("0,vf,11,11,11,") && first.ends_with(",spike,3,box0,11"),
        "{first}"
    );
    let contact = &json_of(&folder.run(&[&command[..], &["--json"]].concat()))["contact"];
    assert_eq!(contact["ids"], json!([11, 11]));
    assert_eq!(contact["parts"], json!(["spike", "box0"]));
    assert_eq!(contact["part_ids"], json!([3, 11]));
    assert_eq!(contact["part_vertices"], json!([[3], [3, 7, 5]]));
    // The page has the ids of the files, too: it shows the bodies beside them.
    assert!(
        folder
            .read("page.html")
            .contains(r#"{"kind":"vertex","id":3,"vertices":[11],"labels":[3]}"#)
    );
    // Edges are numbered in their part, and half spaces are of none.
    let run = folder.run(&[
        "step",
        "box0.obj",
        "box1.obj",
        "--with",
        "spike.obj",
        "--half-space",
        "-1,0,0,-1,0,0",
    ]);
    assert!(run.stdout.contains("box0: vertex 1 and half space 0"), "{run:?}");
}

#[test]
fn groups_of_a_file_are_names() {
    let folder = Folder::new();
    let grouped = |height: f64| {
        format!(
            "o floor\nv 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\no tip\nv 1 1 {height}\nv 1 2 9\nv 2 1 9\nf 4 5 6\n"
        )
    };
    folder.write("start.obj", grouped(1.0));
    folder.write("end.obj", grouped(-1.0));
    let run = folder.run(&["step", "start.obj", "end.obj"]);
    assert!(
        run.stdout
            .contains(": tip: vertex 3 and floor: face 0 (vertices 0, 1, 2)\n"),
        "{run:?}"
    );
    let run = folder.run(&[
        "step",
        "start.obj",
        "end.obj",
        "--with",
        "wall=start.obj",
        "--only",
        "tip:wall",
    ]);
    assert!(!run.stdout.contains("tip: vertex 3 and floor"), "{run:?}");
    // A vertex in two groups has no name.
    folder.write("start.obj", grouped(1.0) + "o both\nf 1 2 4\n");
    folder.write("end.obj", grouped(-1.0) + "o both\nf 1 2 4\n");
    assert!(
        !folder
            .run(&["step", "start.obj", "end.obj"])
            .stdout
            .contains("tip: vertex")
    );
}

/// Two panels with a wire between them, which passes a box.
fn panels() -> Folder {
    let folder = Folder::new();
    let panel = |x: f64| format!("v {x} 0 0\nv {x} 1 0\nv {x} 0 1\n");
    folder.write(
        "panels.obj",
        panel(-2.0) + &panel(2.0) + "v 0 9 0\nf 1 2 3\nf 4 5 6\nl 1 4\np 7\n",
    );
    folder.write("body.obj", cuboid([0.5; 3], 0.0, 0.0));
    folder
}

#[test]
fn faces_alone_leave_out_wires_and_points() {
    let folder = panels();
    let command = ["step", "panels.obj", "panels.obj", "--with", "body.obj"];
    assert_eq!(folder.run(&command).status, 1);
    for option in ["--faces-only", "--faces-only=panels"] {
        let run = folder.run(&[&command[..], &[option]].concat());
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
        let lines = "read: 14 vertices, 24 edges, 14 faces, 3 components\n\
                     left out by --faces-only: loose edges: 1, points: 1\n";
        assert!(run.stdout.starts_with(lines), "{run:?}");
        let report = json_of(&folder.run(&[&command[..], &[option, "--json"]].concat()));
        assert_eq!(report["left_out"], json!({"loose_edges": 1, "points": 1}));
    }
    assert_eq!(
        folder
            .run(&[&command[..], &["--faces-only=body"]].concat())
            .status,
        1
    );
    assert_eq!(
        folder
            .run(&[&command[..], &["--faces-only=sail"]].concat())
            .error(),
        "--faces-only=sail: there is no part sail; there are panels, body"
    );
    // A second part of one name gets a number, also here.
    let twice = ["step", "panels.obj", "panels.obj", "--with", "panels=body.obj"];
    assert_eq!(
        folder
            .run(&[&twice[..], &["--faces-only=panels-2"]].concat())
            .status,
        1
    );
    // Ids are those of the file.
    folder.write(
        "low.obj",
        folder
            .read("panels.obj")
            .replace("v -2 0 0\n", "v -2 0 0\nv 7 7 7\n")
            .replace("f 1 2 3", "f 1 3 4")
            .replace("f 4 5 6", "f 5 6 7")
            .replace("p 7", "p 8")
            .replace("l 1 4", "l 1 5"),
    );
    folder.write(
        "end.obj",
        folder.read("low.obj").replace("v 2 0 0", "v -3 0.25 0.25"),
    );
    let report = json_of(&folder.run(&["step", "low.obj", "end.obj", "--faces-only", "--json"]));
    assert_eq!(report["contact"]["vertices"], json!([[4], [0, 2, 3]]), "{report}");
}

/// Two faces with a seam of this width.
fn seam(width: f64, height: f64) -> String {
    format!(
        "v 0 0 {height}\nv 1 0 {height}\nv 0 1 {height}\nv {} 0 {height}\nv 1 1 {height}\nv 0 {} {height}\n\
         f 1 2 3\nf 4 5 6\n",
        1.0 + width,
        1.0 + width
    )
}

#[test]
fn seams_within_a_tolerance_are_noted_and_welded() {
    let folder = Folder::new();
    folder.write("start.obj", seam(1e-9, 0.0));
    folder.write("end.obj", seam(1e-9, 1.0));
    let step = ["step", "start.obj", "end.obj", "--min-distance", "1e-6"];
    let run = folder.run(&step);
    assert_eq!(run.status, 1);
    assert!(
        note(&run).contains("2 vertices of the part start are at seams, less than 1.5e-6 from others but not in the same place; --weld=1.5e-6 joins"),
        "{run:?}"
    );
    let run = folder.run(&[&step[..], &["--weld=1e-8"]].concat());
    assert_eq!(run.status, 0, "{run:?}");
    assert!(
        run.stdout
            .starts_with("read: 4 vertices, 5 edges, 2 faces, 1 component\n"),
        "{run:?}"
    );
    assert!(
        note(&run).contains("--weld=1e-8 joins 2 vertices of the part start to others, up to 1.0000000"),
        "{run:?}"
    );
    // Exact, and with a tolerance that is too small, the seam stays.
    for option in ["--weld", "--weld=1e-10"] {
        assert_eq!(folder.run(&[&step[..], &[option]].concat()).status, 1, "{option}");
    }
    // A seam that opens is none.
    folder.write("open.obj", seam(0.5, 1.0));
    let run = folder.run(&["step", "start.obj", "open.obj", "--weld=1e-8"]);
    assert!(run.stdout.starts_with("read: 6 vertices"), "{run:?}");
    let error = folder.run(&[&step[..], &["--weld=1e-20"]].concat());
    assert!(
        error.error().starts_with("--weld=1e-20 is below 8.88"),
        "{error:?}"
    );
    for bad in ["--weld=-1", "--weld=nan", "--weld=inf", "--weld=x"] {
        assert_eq!(folder.run(&[&step[..], &[bad]].concat()).status, 2, "{bad}");
    }
}

#[test]
fn a_flat_box_has_no_seam() {
    let folder = Folder::new();
    folder.write("flat.obj", cuboid([1.0, 1.0, 0.0], 0.0, 0.0));
    for command in [&["step", "flat.obj", "flat.obj"][..], &["audit", "flat.obj"]] {
        let run = folder.run(command);
        assert_eq!(run.status, 1);
        let note = note(&run);
        assert!(
            note.contains("faces of the part flat lie on each other"),
            "{note}"
        );
        assert!(!note.contains("--weld"), "{note}");
    }
}
