//! The output of `exact-ccd repair`: a mesh that is free, or the reason why there is none.

use std::fs;

use exact_ccd_check::{check, ply};
use serde_json::{Value, json};

use crate::folder::{Folder, Run};
use crate::schema::Schema;
use crate::verdicts::cuboid;

/// Two boxes that overlap, in one OBJ file with a comment and names of groups.
fn overlapping() -> String {
    let second = cuboid([0.3, 0.4, 0.5], 20.0, 1.2);
    let (points, faces) = second.split_at(second.find('f').unwrap());
    let faces: String = faces
        .lines()
        .map(|line| {
            let corners = line[2..]
                .split(' ')
                .map(|corner| corner.parse::<u32>().unwrap() + 8);
            format!(
                "f{}\n",
                corners.map(|corner| format!(" {corner}")).collect::<String>()
            )
        })
        .collect();
    format!(
        "# two boxes\ng large\n{}g small\n{points}{faces}",
        cuboid([1.0; 3], 0.0, 0.0)
    )
}

fn json_of(run: &Run) -> Value {
    let report = serde_json::from_str(&run.stdout).unwrap();
    Schema::of_reports().assert("repair", &report);
    report
}

#[test]
fn a_repaired_file_is_free_and_the_same_otherwise() {
    let folder = Folder::new();
    folder.write("boxes.obj", overlapping());
    let run = folder.run(&["repair", "boxes.obj", "-o", "free.obj", "--view", "page.html"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{run:?}");
    assert!(
        run.stdout.contains("\nrepaired: free of contact at rest\n"),
        "{run:?}"
    );
    assert_eq!(folder.run(&["audit", "boxes.obj"]).status, 1);
    assert_eq!(folder.run(&["audit", "free.obj"]).status, 0);
    let without_vertices = |name: &str| -> Vec<String> {
        let text = folder.read(name);
        text.lines()
            .filter(|line| !line.starts_with('v'))
            .map(str::to_owned)
            .collect()
    };
    assert_eq!(without_vertices("boxes.obj"), without_vertices("free.obj"));
    assert!(
        folder
            .read("page.html")
            .contains("repaired: free of contact at rest")
    );
    // A mesh that is free keeps its bits.
    let again = folder.run(&["repair", "free.obj", "-o", "again.obj"]);
    assert!(
        again.stdout.contains("\nfree before: nothing moved\n"),
        "{again:?}"
    );
    assert_eq!(folder.read("again.obj"), folder.read("free.obj"));
}

#[test]
fn obstacles_and_pinned_groups_stay() {
    let folder = Folder::new();
    folder.write("large.obj", cuboid([1.0; 3], 0.0, 0.0));
    folder.write("small.obj", cuboid([0.3, 0.4, 0.5], 20.0, 1.2));
    let run = folder.run(&["repair", "small.obj", "-o", "free.obj", "--with", "large.obj"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{run:?}");
    assert_eq!(
        folder
            .read("free.obj")
            .lines()
            .filter(|line| line.starts_with('v'))
            .count(),
        8
    );
    assert_eq!(
        folder.run(&["audit", "free.obj", "--with", "large.obj"]).status,
        0
    );

    // The obstacle is not in single precision, and not written.
    folder.write("large.obj", cuboid([1.1; 3], 0.1, 0.0));
    let run = folder.run(&[
        "repair",
        "small.obj",
        "-o",
        "single.ply",
        "--f32",
        "--with",
        "large.obj",
    ]);
    assert_eq!(run.status, 0, "{run:?}");
    assert_eq!(
        folder.run(&["audit", "single.ply", "--with", "large.obj"]).status,
        0
    );

    folder.write("boxes.obj", overlapping());
    let run = folder.run(&["repair", "boxes.obj", "-o", "pinned.obj", "--pin", "large"]);
    assert_eq!(run.status, 0, "{run:?}");
    let numbers = |name: &str| -> Vec<f64> {
        let text = folder.read(name);
        let vertices = text.lines().filter_map(|line| line.strip_prefix("v ")).take(8);
        vertices
            .flat_map(|line| line.split(' ').map(|x| x.parse().unwrap()).collect::<Vec<_>>())
            .collect()
    };
    assert_eq!(numbers("boxes.obj"), numbers("pinned.obj"));
    // All is pinned: the reason is known before the first round.
    let run = folder.run(&[
        "repair",
        "boxes.obj",
        "-o",
        "no.obj",
        "--pin",
        "large",
        "--pin",
        "small",
    ]);
    assert_eq!(run.status, 1);
    assert!(
        run.stdout
            .contains("\nnot repaired: vertices that do not move intersect or touch each other\n"),
        "{run:?}"
    );
    assert!(!folder.path("no.obj").exists());
}

#[test]
fn the_contacts_that_remain_are_named_with_their_bodies() {
    let folder = Folder::new();
    // The upper one of two plates stands on the lower one with its tip.
    folder.write(
        "boxes.obj",
        "g floor\nv 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\ng tip\nv 1 1 0\nv 1 2 3\nv 2 1 3\nf 4 5 6\n",
    );
    let command = [
        "repair",
        "boxes.obj",
        "-o",
        "no.obj",
        "--pin",
        "floor",
        "--pin",
        "tip",
    ];
    let run = folder.run(&command);
    assert_eq!(run.status, 1, "{run:?}");
    let contact = "tip: vertex 3 and floor: face 0 (vertices 0, 1, 2)";
    assert!(
        run.stdout.contains(&format!("\n  contact: {contact}\n")),
        "{run:?}"
    );
    let report = json_of(&folder.run(&[&command[..], &["--json"]].concat()));
    assert_eq!(report["contacts"], json!([contact]));
    assert_eq!(report.get("crossings"), None);
}

#[test]
fn a_closed_surface_with_one_side_is_refused_with_its_body_and_a_face() {
    // A triangle, and the projective plane of six vertices.
    let folder = Folder::new();
    let faces = "f 4 5 6\nf 4 6 7\nf 4 7 8\nf 4 8 9\nf 4 9 5\nf 5 6 8\nf 6 7 9\nf 7 8 5\nf 8 9 6\nf 9 5 7\n";
    let plane = "g plane\nv 0 0 2\nv 1 0 0\nv 0.3 1 0.1\nv -0.8 0.6 0\nv -0.8 -0.6 0.2\nv 0.3 -1 0\n";
    let triangle = "g far\nv 9 0 0\nv 9 1 0\nv 9 0 1\nf 1 2 3\n";
    folder.write("both.obj", format!("{triangle}{plane}{faces}"));
    let run = folder.run(&["repair", "both.obj", "-o", "no.obj"]);
    assert_eq!(run.status, 1, "{run:?}");
    let reason = "\nnot repaired: face 1 of plane is part of a closed surface that has only one side, as a Klein bottle: \
                  such a surface has no positions without intersections\n";
    assert!(run.stdout.contains(reason), "{run:?}");
}

#[test]
fn a_mesh_that_is_not_repaired_is_written_on_request_only() {
    let folder = Folder::new();
    folder.write("boxes.obj", overlapping());
    let command = ["repair", "boxes.obj", "-o", "out.obj", "--max-rounds", "0"];
    let run = folder.run(&command);
    assert_eq!((run.status, run.stderr.as_str()), (1, ""), "{run:?}");
    assert!(
        run.stdout
            .contains("\nnot repaired: the limit of rounds was reached"),
        "{run:?}"
    );
    assert!(!folder.path("out.obj").exists());
    let report = json_of(&folder.run(&[&command[..], &["--json", "--partial"]].concat()));
    assert_eq!(
        (&report["repaired"], &report["output"]),
        (&false.into(), &"out.obj".into())
    );
    assert!(report["after"]["crossings"].as_u64() > Some(0));
    assert_eq!(folder.run(&["audit", "out.obj"]).status, 1);
    // A displacement beyond the limit is no repair.
    let run = folder.run(&[
        "repair",
        "boxes.obj",
        "-o",
        "far.obj",
        "--max-displacement",
        "1e-9",
    ]);
    assert_eq!(run.status, 1);
    assert!(
        run.stdout.contains(", more than --max-displacement 1e-9\n"),
        "{run:?}"
    );
    assert!(!folder.path("far.obj").exists());
}

#[test]
fn single_precision_and_the_certificate_are_about_the_written_file() {
    let folder = Folder::new();
    folder.write("boxes.obj", overlapping());
    let command = [
        "repair",
        "boxes.obj",
        "-o",
        "free.ply",
        "--f32",
        "--min-distance",
        "0.001",
    ];
    let run = folder.run(&[&command[..], &["--certificate", "proof", "--json"]].concat());
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{run:?}");
    let report = json_of(&run);
    assert_eq!(report["repaired"], true);
    let change = &report["change"];
    assert!(change["area"]["p95"].as_f64() >= change["area"]["p5"].as_f64());
    assert!(change["aspect"]["after"].as_f64() >= Some(1.0), "{change}");
    assert!(change["folds"].is_u64(), "{change}");
    assert!(report["before"]["crossings"].as_u64() > Some(0));
    let frame = || ply::read(&fs::read(folder.path("free.ply")).unwrap());
    let positions = exact_ccd_files::read_frame(folder.path("free.ply"))
        .unwrap()
        .positions;
    assert!(positions.as_flattened().iter().all(|&x| f64::from(x as f32) == x));
    let certificate = fs::read(folder.path("proof")).unwrap();
    let proved = check(&certificate, [frame(), frame()]).unwrap();
    assert!(proved.steps[0].head.rest);
    assert_eq!(
        folder
            .run(&["audit", "free.ply", "--min-distance", "0.001"])
            .status,
        0
    );
}

#[test]
fn errors_name_the_remedy() {
    let folder = Folder::new();
    folder.write("boxes.obj", overlapping());
    let run = folder.run(&["repair", "boxes.obj", "-o", "out.stl"]);
    assert_eq!(
        run.error(),
        "out.stl: the repaired mesh is a PLY or an OBJ file: name one that ends in .ply or .obj"
    );
    assert!(
        folder
            .run(&["repair", "boxes.obj", "-o", "boxes.obj"])
            .error()
            .contains("input")
    );
    let run = folder.run(&["repair", "boxes.obj", "-o", "out.obj", "--pin", "lid"]);
    assert!(
        run.error()
            .starts_with("there is no part or group lid; there are "),
        "{run:?}"
    );
    let run = folder.run(&["repair", "boxes.obj", "-o", "out.obj", "--max-seconds", "-1"]);
    assert!(run.error().starts_with("--max-seconds: "), "{run:?}");
}

#[test]
fn a_body_that_ends_up_inside_another_one_is_named() {
    let folder = Folder::new();
    folder.write("large.obj", cuboid([1.0; 3], 0.0, 0.0));
    folder.write("small.obj", cuboid([0.3, 0.4, 0.5], 20.0, 0.9));
    let run = folder.run(&["repair", "small.obj", "-o", "free.obj", "--with", "large.obj"]);
    assert_eq!(run.status, 0, "{run:?}");
    assert!(
        run.stderr.contains("lies inside of the closed surface of large"),
        "{run:?}"
    );
}
