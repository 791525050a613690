//! Reports of `exact-ccd step`.

use exact_ccd::AnyKind;
use exact_ccd_mesh::{
    Bvh, Contact, Frame, IntersectionOptions, Meeting, Motion, Pair, PairCounts, Point, StepReport,
    contact_points, intersections, step,
};
use proptest::prelude::*;
use serde_json::{Value, json};

use crate::folder::{Folder, Run};
use crate::meshes::{fall, obj, off, ply, stl, text_ply, tip_above_square};

/// A report without the seconds, which are at its end in both forms.
#[track_caller]
pub(crate) fn without_seconds(run: &Run) -> &str {
    assert_eq!(run.stderr, "");
    let end = run.stdout.find("seconds").unwrap();
    &run.stdout[..end]
}

/// The answer in a report: its lines without the contents of the files, the place of the contact, and the
/// seconds.
#[track_caller]
pub(crate) fn answer(run: &Run) -> String {
    let is_answer = |line: &&str| !line.starts_with("read: ") && !line.starts_with("  at (");
    let lines = without_seconds(run).lines().filter(is_answer);
    lines.map(|line| line.to_owned() + "\n").collect()
}

/// The expected JSON object of a contact.
fn record(kind: &str, motion: &Motion, contact: &Contact) -> Value {
    let vertices = contact.pair.vertices(&motion.mesh).unwrap();
    let (first, second) = vertices.split_at(contact.pair.kind().sizes()[0]);
    let points = contact_points([first, second], [&motion.x0, &motion.x1], &contact.impact).unwrap();
    let time = contact.impact.time;
    json!({
        "frame": 0,
        "files": ["start.ply", "end.ply"],
        "kind": kind,
        "ids": contact.pair.ids(),
        "vertices": [first, second],
        "time": {"lower": time.lower(), "upper": time.upper()},
        "point": points[0],
        "normal": contact.impact.normal.map(|normal| normal.map(|x| x + 0.0)),
        "parameters": contact.impact.parameters,
        "distance": {"lower": contact.distance.lower, "upper": contact.distance.upper},
    })
}

/// The expected fields of the JSON object about the step, without the seconds.
fn expected(motion: &Motion, report: &StepReport) -> Value {
    let contact = report.earliest.map(|earliest| {
        let kind = match earliest.pair {
            Pair::VertexFace { .. } => "vf",
            Pair::EdgeEdge { .. } => "ee",
            Pair::VertexEdge { .. } => "ve",
            Pair::VertexVertex { .. } => "vv",
        };
        record(kind, motion, &earliest)
    });
    let counts = |counts: PairCounts| {
        json!({
            "vf": counts[AnyKind::VertexFace],
            "ee": counts[AnyKind::EdgeEdge],
            "ve": counts[AnyKind::VertexEdge],
            "vv": counts[AnyKind::VertexVertex],
        })
    };
    let crossing = IntersectionOptions::default().with_meeting(Meeting::Crossing);
    let found = intersections(&motion.mesh, &motion.x0, &Bvh, &crossing).unwrap();
    json!({
        "version": 1,
        "command": "step",
        "frames": 2,
        "examined": 2,
        "intersections": found.len(),
        "min_distance": 0.0,
        "collision_free": report.is_free() && found.is_empty(),
        "toi": report.time_of_impact(),
        "contact": contact,
        "touching_at_start": report.touching.total(),
        "candidates": counts(report.candidates),
        "colliding": counts(report.colliding),
    })
}

#[test]
fn a_free_step_has_status_0() {
    let run = fall(1.0, 0.5).run(&["step", "start.ply", "end.ply"]);
    assert_eq!(run.status, 0);
    assert_eq!(
        answer(&run),
        "free of contact\n\
         candidate pairs: 2 vertex-face, 0 edge-edge\n\
         pairs that touch at t = 0: 0\n"
    );
}

#[test]
fn a_step_with_contact_has_status_1_and_names_the_pair() {
    let run = fall(1.0, -2.0).run(&["step", "start.ply", "end.ply"]);
    assert_eq!(run.status, 1);
    assert_eq!(
        answer(&run),
        "contact at t = 0.3333333333333333: vertex 4 and face 1 (vertices 2, 1, 3)\n\
         candidate pairs: 8 vertex-face, 5 edge-edge\n\
         pairs in contact: 4 vertex-face, 4 edge-edge\n\
         pairs that touch at t = 0: 0\n"
    );
}

#[test]
fn the_earliest_contact_alone_is_that_of_the_report() {
    let folder = fall(1.0, -2.0);
    let run = folder.run(&["step", "start.ply", "end.ply", "--toi"]);
    assert_eq!(run.status, 1);
    assert_eq!(
        answer(&run),
        "contact at t = 0.3333333333333333: vertex 4 and face 1 (vertices 2, 1, 3)\n"
    );
    let [all, earliest] = [&["--json"][..], &["--json", "--toi", "--repeat", "3"]].map(|flags| {
        let run = folder.run(&[&["step", "start.ply", "end.ply"], flags].concat());
        serde_json::from_str::<Value>(&run.stdout).unwrap()
    });
    for key in ["collision_free", "toi", "contact"] {
        assert_eq!(all[key], earliest[key]);
    }
    assert_eq!(earliest.get("candidates"), None);
    assert_eq!(earliest.get("touching_at_start"), None);

    let run = fall(1.0, 0.5).run(&["step", "start.ply", "end.ply", "--toi"]);
    assert_eq!((run.status, answer(&run).as_str()), (0, "free of contact\n"));
}

#[test]
fn the_report_of_a_decision_has_no_counts() {
    for (end, status, expected) in [(-2.0, 1, "contact\n"), (0.5, 0, "free of contact\n")] {
        let folder = fall(1.0, end);
        let run = folder.run(&["step", "start.ply", "end.ply", "--any"]);
        assert_eq!((run.status, answer(&run).as_str()), (status, expected));
        let run = folder.run(&["step", "start.ply", "end.ply", "--any", "--json"]);
        let json: Value = serde_json::from_str(&run.stdout).unwrap();
        assert_eq!(json["collision_free"], json!(status == 0));
        assert_eq!(json["min_distance"], 0.0);
        for key in ["toi", "contact", "intersection"] {
            assert_eq!(json[key], Value::Null);
        }
        assert_eq!(json.get("candidates"), None);
    }
    let both = fall(1.0, 0.5).run(&["step", "start.ply", "end.ply", "--any", "--toi"]);
    assert_eq!(both.status, 2);
}

/// Each phase has its duration, and the total is their sum: nothing is done beside them. Files have theirs.
#[test]
fn the_seconds_are_those_of_all_phases() {
    let folder = fall(0.0, -2.0);
    let phases = ["broad", "narrow", "read", "start"];
    for (options, files) in [
        (&[][..], &[][..]),
        (&["--toi"], &[]),
        (&["--any"], &[]),
        (&["--any", "--half-space", "0,0,0,0,0,1"], &["half_spaces"]),
        (&["--toi", "--all", "all.csv"], &["list", "write"]),
        (&["--any", "--view", "page.html"], &["list", "write"]),
        (&["--paraview", "out", "--repeat", "3"], &["list", "write"]),
    ] {
        let run = folder.run(&[&["step", "start.ply", "end.ply", "--json"], options].concat());
        let report: Value = serde_json::from_str(&run.stdout).unwrap();
        let mut seconds = report["seconds"].as_object().unwrap().clone();
        let total = seconds.remove("total").unwrap().as_f64().unwrap();
        let sum: f64 = seconds.values().map(|value| value.as_f64().unwrap()).sum();
        assert!((total - sum).abs() < 1e-9, "{run:?}");
        let mut names: Vec<&str> = seconds.keys().map(String::as_str).collect();
        names.sort_unstable();
        let mut expected = [&phases[..], files].concat();
        expected.sort_unstable();
        assert_eq!(names, expected, "{options:?}");
        let run = folder.run(&[&["step", "start.ply", "end.ply"], options].concat());
        let line = run.stdout.lines().last().unwrap();
        let has = |name: &&str| line.contains(&format!(" {name}, "));
        assert!(expected.iter().all(has), "{line}");
    }
}

#[test]
fn two_edges_are_named_with_their_ends() {
    let folder = Folder::new();
    let frame = |z| {
        let across = [[0.0, -1.0, z], [0.0, 1.0, z], [0.0, 0.0, z + 1.0]];
        let along = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]];
        Frame::new([along, across].concat(), vec![[0, 1, 2], [3, 4, 5]]).unwrap()
    };
    folder.write("start.ply", ply(&frame(1.0)));
    folder.write("end.ply", ply(&frame(-1.0)));
    let run = folder.run(&["step", "start.ply", "end.ply"]);
    assert_eq!(run.status, 1);
    assert_eq!(
        run.stdout.lines().nth(1),
        Some("contact at t = 0.5: edge 0 (vertices 0, 1) and edge 3 (vertices 3, 4)")
    );
    assert_eq!(
        run.stdout.lines().nth(2),
        Some("  at (0, 0, 0), normal (0, 0, -1), parameters 0.5, 0.5; ids count from 0")
    );
}

#[test]
fn a_pair_in_contact_at_the_start_is_counted() {
    let run = fall(0.0, 0.5).run(&["step", "start.ply", "end.ply"]);
    assert_eq!(run.status, 1);
    assert_eq!(
        answer(&run),
        "contact at t = 0: vertex 4 and face 1 (vertices 2, 1, 3)\n\
         candidate pairs: 4 vertex-face, 3 edge-edge\n\
         pairs in contact: 1 vertex-face, 0 edge-edge\n\
         pairs that touch at t = 0: 1\n"
    );
}

#[test]
fn a_report_begins_with_what_was_read() {
    let run = fall(1.0, 0.5).run(&["step", "start.ply", "end.ply"]);
    assert!(
        run.stdout
            .starts_with("read: 7 vertices, 8 edges, 3 faces, 2 components\nfree of contact\n"),
        "{run:?}"
    );
    let run = fall(1.0, 0.5).run(&["step", "start.ply", "end.ply", "--json"]);
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(
        report["read"],
        json!({
            "vertices": 7, "edges": 8, "faces": 3, "loose_edges": 0, "loose_vertices": 0, "components": 2,
            "polygons": 0, "solids": 0,
        })
    );
}

#[test]
fn json_is_one_line_with_these_keys_in_this_order() {
    let run = fall(1.0, -2.0).run(&["step", "start.ply", "end.ply", "--json"]);
    assert_eq!(run.status, 1);
    assert_eq!(
        without_seconds(&run),
        "{\"version\":1,\"command\":\"step\",\"read\":{\"vertices\":7,\"edges\":8,\"faces\":3,\"loose_edges\":0,\"loose_vertices\":0,\"components\":2,\
         \"polygons\":0,\"solids\":0},\"min_distance\":0.0,\"collision_free\":false,\
         \"frames\":2,\"examined\":2,\
         \"intersection\":null,\"toi\":0.3333333333333333,\
         \"contact\":{\"frame\":0,\"kind\":\"vf\",\"ids\":[4,1],\"vertices\":[[4],[2,1,3]],\
         \"time\":{\"lower\":0.3333333333333333,\"upper\":0.33333333333333337},\
         \"point\":[0.75,0.5,1.1102230246251565e-16],\"normal\":[0.0,0.0,1.0],\"parameters\":[0.5,0.25],\
         \"distance\":{\"lower\":0.0,\"upper\":0.0},\"files\":[\"start.ply\",\"end.ply\"]},\
         \"intersections\":0,\"touching_at_start\":0,\"candidates\":{\"vf\":8,\"ee\":5,\"ve\":0,\"vv\":0},\
         \"colliding\":{\"vf\":4,\"ee\":4,\"ve\":0,\"vv\":0},\""
    );
    assert_eq!(run.stdout.find('\n'), Some(run.stdout.len() - 1));
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    let seconds = report["seconds"].as_object().unwrap();
    assert!(
        seconds
            .values()
            .all(|value| value.as_f64().is_some_and(|value| value >= 0.0))
    );
}

#[test]
fn json_of_a_free_step_has_nulls() {
    let run = fall(1.0, 0.5).run(&["step", "--json", "start.ply", "end.ply"]);
    assert_eq!(run.status, 0);
    assert_eq!(
        without_seconds(&run),
        "{\"version\":1,\"command\":\"step\",\"read\":{\"vertices\":7,\"edges\":8,\"faces\":3,\"loose_edges\":0,\"loose_vertices\":0,\"components\":2,\
         \"polygons\":0,\"solids\":0},\"min_distance\":0.0,\"collision_free\":true,\
         \"frames\":2,\"examined\":2,\
         \"intersection\":null,\"toi\":null,\"contact\":null,\"intersections\":0,\"touching_at_start\":0,\
         \"candidates\":{\"vf\":2,\"ee\":0,\"ve\":0,\"vv\":0},\"colliding\":{\"vf\":0,\"ee\":0,\"ve\":0,\"vv\":0},\""
    );
}

#[test]
fn all_formats_give_the_same_answer() {
    let folder = Folder::new();
    for (name, height) in [("start", 1.0), ("end", -2.0)] {
        let frame = tip_above_square(height);
        folder.write(&format!("{name}.ply"), ply(&frame));
        folder.write(&format!("{name}-text.PLY"), text_ply(&frame));
        folder.write(&format!("{name}.obj"), obj(&frame));
        folder.write(&format!("{name}.off"), off(&frame));
        folder.write(&format!("{name}.stl"), stl(&frame));
    }
    let step = |start, end| folder.run(&["step", "--json", start, end]);
    let expected = step("start.ply", "end.ply");
    assert_eq!(expected.status, 1);
    for (start, end) in [
        ("start-text.PLY", "end-text.PLY"),
        ("start.obj", "end.obj"),
        ("start.off", "end.off"),
        ("start.stl", "end.stl"),
        ("start.obj", "end.ply"),
    ] {
        let run = step(start, end);
        assert_eq!(run.status, 1, "{start}, {end}");
        let files = format!("[\"{start}\",\"{end}\"]");
        let expected = without_seconds(&expected);
        let mut expected = expected.replace("[\"start.ply\",\"end.ply\"]", &files);
        if start == "start.stl" {
            // The ids are the ids in the file, three for each facet.
            let [ids, of_stl] = [
                "\"ids\":[4,1],\"vertices\":[[4],[2,1,3]]",
                "\"ids\":[6,1],\"vertices\":[[6],[2,1,5]]",
            ];
            assert!(expected.contains(ids), "{expected}");
            expected = expected.replace(ids, of_stl);
        }
        assert_eq!(without_seconds(&run), expected, "{start}, {end}");
    }
}

prop_compose! {
    /// Triangles without shared vertices. Most of them touch during the step.
    pub(crate) fn triangles(count: usize)(
        points in prop::collection::vec(prop::array::uniform3(-1.0..1.0), 3 * count)
    ) -> Vec<Point> {
        points
    }
}

proptest! {
    // Each case starts the program a few times.
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn the_answer_is_that_of_the_library_on_any_number_of_threads(
        x0 in triangles(6),
        x1 in triangles(6),
        scale in 0.0..1.0,
    ) {
        let x1: Vec<Point> = x0
            .iter()
            .zip(&x1)
            .map(|(p, q)| [0, 1, 2].map(|axis| p[axis] + scale * q[axis]))
            .collect();
        let faces = (0..6).map(|face| [0, 1, 2].map(|corner| 3 * face + corner));
        let frame = |x: &[Point]| Frame::new(x.to_vec(), faces.clone().collect()).unwrap();
        let motion = Motion::new(frame(&x0), frame(&x1)).unwrap();
        let expected = expected(&motion, &step(&motion.mesh, &x0, &x1).unwrap());

        let folder = Folder::new();
        folder.write("start.ply", ply(&frame(&x0)));
        folder.write("end.ply", ply(&frame(&x1)));
        for threads in ["1", "2", "7"] {
            let run = folder.run(&["step", "start.ply", "end.ply", "--json", "--threads", threads]);
            let mut report: Value = serde_json::from_str(&run.stdout).unwrap();
            for key in ["seconds", "read", "intersection"] {
                report.as_object_mut().unwrap().remove(key).unwrap();
            }
            prop_assert_eq!(&report, &expected);
            prop_assert_eq!(run.status == 0, report["collision_free"] == true);
            prop_assert_eq!(run.status == 1, report["collision_free"] == false);
        }
    }
}
