//! `exact-ccd step --half-space`.

use exact_ccd_mesh::Frame;
use serde_json::{Value, json};

use crate::folder::{Folder, Run};
use crate::meshes::{fall, ply, stl, tip_above_square};
use crate::schema::Schema;

/// A triangle whose tip, vertex 0, falls from height 2 to −1; the others rise from 4 to 5.
fn tip() -> Folder {
    let at = |tip: f64, others: f64| {
        let positions = vec![[0.25, 0.25, tip], [1.0, 0.0, others], [0.0, 1.0, others]];
        ply(&Frame::new(positions, vec![[0, 1, 2]]).unwrap())
    };
    let folder = Folder::new();
    folder.write("start.ply", at(2.0, 4.0));
    folder.write("end.ply", at(-1.0, 5.0));
    folder
}

fn step(folder: &Folder, options: &[&str]) -> Run {
    folder.run(&[&["step", "start.ply", "end.ply"], options].concat())
}

#[track_caller]
fn report(folder: &Folder, options: &[&str]) -> Value {
    let run = step(folder, &[options, &["--json"]].concat());
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    Schema::of_reports().assert("motion", &report);
    assert_eq!(run.status, i32::from(report["collision_free"] == false));
    report
}

#[test]
fn the_first_time_in_a_half_space_is_exact() {
    let folder = tip();
    // The tip is at 2 − 3 t.
    let third = 2.0_f64 / 3.0;
    for (height, options, [lower, upper], distance) in [
        ("0,0,0,0,0,3", &[][..], [third, third.next_up()], 0.0),
        ("9 9 0.5 0 0 1", &[], [0.5, 0.5], 0.0),
        ("0,0,2,0,0,1", &[], [0.0, 0.0], 0.0),
        ("0,0,-1,0,0,1", &[], [1.0, 1.0], 0.0),
        ("0,0,0,0,0,1", &["--min-distance", "0.5"], [0.5, 0.5], 0.5),
    ] {
        let half_space = [options, &["--half-space", height]].concat();
        let report = report(&folder, &half_space);
        let contact = &report["contact"];
        assert_eq!(report["toi"], json!(lower), "{height}");
        assert_eq!(
            contact["time"],
            json!({"lower": lower, "upper": upper}),
            "{height}"
        );
        assert_eq!(
            json!([
                contact["kind"],
                contact["ids"],
                contact["vertices"],
                contact["normal"]
            ]),
            json!(["vh", [0, 0], [[0], []], [0.0, 0.0, 1.0]])
        );
        assert_eq!(contact["distance"], json!({"lower": distance, "upper": distance}));
        let place = contact["point"][2].as_f64().unwrap();
        assert!((place - (2.0 - 3.0 * lower)).abs() < 1e-15, "{place}");
        let [touching, colliding] = [usize::from(lower == 0.0), 1];
        assert_eq!(
            report["half_spaces"],
            json!({"touching_at_start": touching, "colliding": colliding})
        );
    }
    let above = report(&folder, &["--half-space", "0,0,-1.0000000000000002,0,0,1"]);
    assert_eq!(
        json!([above["collision_free"], above["toi"]]),
        json!([true, null])
    );
    assert_eq!(
        above["half_spaces"],
        json!({"touching_at_start": 0, "colliding": 0})
    );
    assert_eq!(report(&folder, &[]).get("half_spaces"), None);
}

#[test]
fn every_form_of_the_answer_has_the_half_spaces() {
    let folder = tip();
    let half_space = ["--half-space", "0,0,0.5,0,0,1"];
    let run = step(&folder, &half_space);
    let [first, place, counts] = [
        "contact at t = 0.5: vertex 0 and half space 0\n",
        "  at (0.25, 0.25, 0.5), normal (0, 0, 1); ids count from 0\n",
        "vertices in contact with half spaces: 1; those that touch at t = 0: 0\n",
    ];
    assert!(
        run.stdout.contains(&format!("{first}{place}")) && run.stdout.contains(counts),
        "{run:?}"
    );
    assert!(
        run.stdout.contains(" half_spaces, ") && run.status == 1,
        "{run:?}"
    );
    let run = step(&folder, &[&half_space[..], &["--any"]].concat());
    assert!(run.stdout.contains("contact\n") && run.status == 1, "{run:?}");
    let run = step(&folder, &[&half_space[..], &["--toi"]].concat());
    assert!(run.stdout.contains(first) && run.status == 1, "{run:?}");
    // The same vertices as an obstacle may be where they are.
    let run = step(
        &folder,
        &[
            &half_space[..],
            &["--with", "wall=end.ply", "--ignore", "start:wall"],
        ]
        .concat(),
    );
    assert!(run.stdout.contains(counts), "{run:?}");
    let bad = step(&folder, &["--half-space", "0,0,0"]);
    assert!(
        bad.status == 2 && bad.stderr.contains("expected six numbers"),
        "{bad:?}"
    );
}

/// Half spaces and the mesh itself, in the order of times.
#[test]
fn the_list_has_the_contacts_of_both() {
    // The tip, vertex 4, falls from 1 to −1 through a square at 0, and touches the square at t = 0.5.
    let folder = fall(1.0, -1.0);
    let planes = ["--half-space", "0,0,0.5,0,0,1", "--half-space", "0,0,-0.5,0,0,1"];
    let run = step(
        &folder,
        &[&planes[..], &["--all", "all.jsonl", "--paraview", "out"]].concat(),
    );
    assert_eq!(run.status, 1, "{run:?}");
    let list = folder.read("all.jsonl");
    let records: Vec<Value> = list
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let schema = Schema::of_reports();
    records.iter().for_each(|record| schema.assert("contact", record));
    let lower: Vec<f64> = records
        .iter()
        .map(|record| record["time"]["lower"].as_f64().unwrap())
        .collect();
    assert!(lower.is_sorted(), "{lower:?}");
    // The four corners of the square are in the first half space at rest; vertices come in their order.
    let of = |half_space: u32| -> Vec<Value> {
        let is_of = |record: &&Value| record["kind"] == "vh" && record["ids"][1] == half_space;
        let times = records.iter().filter(is_of);
        times
            .map(|record| json!([record["ids"][0], record["time"]["lower"]]))
            .collect()
    };
    let corners = [0, 1, 2, 3].map(|vertex| json!([vertex, 0.0]));
    assert_eq!(of(0), [&corners[..], &[json!([4, 0.25])]].concat());
    assert_eq!(of(1), [json!([4, 0.75])]);
    assert!(
        records
            .iter()
            .any(|record| record["kind"] == "vf" && record["time"]["lower"] == 0.5)
    );
    let impact = exact_ccd_files::read_frame(folder.path("out/impact.vtu")).unwrap();
    assert_eq!(impact.positions[4], [0.75, 0.5, 1.0]);
}

#[test]
fn vertices_that_start_within_the_distance_have_the_inner_one() {
    let folder = tip();
    // The tip starts 1 above the plane, and comes within 0.25 of it at t = 0.25.
    let options = [
        "--half-space",
        "0,0,1,0,0,1",
        "--min-distance",
        "1",
        "--inner-distance",
        "0.25",
    ];
    let report = report(&folder, &options);
    assert_eq!(report["toi"], json!(0.25));
    assert_eq!(
        report["half_spaces"],
        json!({"touching_at_start": 1, "colliding": 1})
    );
}

#[test]
fn points_alone_have_half_spaces() {
    let folder = Folder::new();
    for (name, height) in [("start.obj", 1.0), ("end.obj", -1.0)] {
        folder.write(name, format!("v 0 0 {height}\n"));
    }
    for command in ["step", "audit"] {
        let run = folder.run(&[
            command,
            "start.obj",
            "end.obj",
            "--points",
            "--half-space",
            "0,0,0,0,0,1",
        ]);
        assert_eq!(run.status, 1, "{run:?}");
        assert!(run.stdout.contains("vertex 0 and half space 0"), "{run:?}");
    }
}

/// The vertices of a welded part are fewer than those of its files.
#[test]
fn welded_vertices_stay_out_of_a_half_space() {
    let folder = Folder::new();
    folder.write("start.stl", stl(&tip_above_square(1.0)));
    folder.write("end.stl", stl(&tip_above_square(0.5)));
    for command in ["step", "audit"] {
        for (half_space, status) in [("0,0,-1,0,0,1", 0), ("0,0,0,0,0,1", 1)] {
            let run = folder.run(&[command, "start.stl", "end.stl", "--half-space", half_space]);
            assert_eq!(run.status, status, "{run:?}");
        }
    }
}
