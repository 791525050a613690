//! Reports of `exact-ccd step`.

use exact_ccd_mesh::{Contact, Frame, Motion, Pair, Point, StepReport, step};
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

/// The expected JSON object of a pair.
fn pair(kind: &str, ids: [u32; 2], contact: &Contact) -> Value {
    let distance = json!({"lower": contact.distance.lower, "upper": contact.distance.upper});
    json!({"kind": kind, "ids": ids, "distance": distance})
}

/// The expected fields of the JSON object, without the seconds.
fn expected(report: &StepReport) -> Value {
    let pair = report.earliest.map(|earliest| match earliest.pair {
        Pair::VertexFace { vertex, face } => pair("vf", [vertex, face], &earliest),
        Pair::EdgeEdge { a, b } => pair("ee", [a, b], &earliest),
        Pair::VertexEdge { vertex, edge } => pair("ve", [vertex, edge], &earliest),
        Pair::VertexVertex { a, b } => pair("vv", [a, b], &earliest),
    });
    let candidates = report.candidates;
    json!({
        "min_distance": 0.0,
        "collision_free": report.is_free(),
        "toi": report.time_of_impact(),
        "pair": pair,
        "touching_at_start": report.touching.total(),
        "candidates": {
            "vf": candidates.vertex_face,
            "ee": candidates.edge_edge,
            "ve": candidates.vertex_edge,
            "vv": candidates.vertex_vertex,
        },
    })
}

#[test]
fn a_free_step_has_status_0() {
    let run = fall(1.0, 0.5).run(&["step", "start.ply", "end.ply"]);
    assert_eq!(run.status, 0);
    assert_eq!(
        without_seconds(&run),
        "free of contact\n\
         candidates: 2 vertex-face pairs, 0 edge-edge pairs\n\
         touching at t = 0: 0 pairs\n"
    );
}

#[test]
fn a_step_with_contact_has_status_1_and_names_the_pair() {
    let run = fall(1.0, -2.0).run(&["step", "start.ply", "end.ply"]);
    assert_eq!(run.status, 1);
    assert_eq!(
        without_seconds(&run),
        "contact at t = 0.3333333333333333: vertex 4 and face 1 (vertices 2, 1, 3)\n\
         candidates: 8 vertex-face pairs, 5 edge-edge pairs\n\
         touching at t = 0: 0 pairs\n"
    );
}

#[test]
fn the_earliest_contact_alone_is_that_of_the_report() {
    let folder = fall(1.0, -2.0);
    let run = folder.run(&["step", "start.ply", "end.ply", "--toi"]);
    assert_eq!(run.status, 1);
    assert_eq!(
        without_seconds(&run),
        "contact at t = 0.3333333333333333: vertex 4 and face 1 (vertices 2, 1, 3)\n"
    );
    let [all, earliest] = [&["--json"][..], &["--json", "--toi", "--repeat", "3"]].map(|flags| {
        let run = folder.run(&[&["step", "start.ply", "end.ply"], flags].concat());
        serde_json::from_str::<Value>(&run.stdout).unwrap()
    });
    for key in ["collision_free", "toi", "pair"] {
        assert_eq!(all[key], earliest[key]);
    }
    assert_eq!(earliest.get("candidates"), None);
    assert_eq!(earliest.get("touching_at_start"), None);

    let run = fall(1.0, 0.5).run(&["step", "start.ply", "end.ply", "--toi"]);
    assert_eq!((run.status, without_seconds(&run)), (0, "free of contact\n"));
}

#[test]
fn the_report_of_a_decision_has_no_counts() {
    for (end, status, answer) in [(-2.0, 1, "contact\n"), (0.5, 0, "free of contact\n")] {
        let folder = fall(1.0, end);
        let run = folder.run(&["step", "start.ply", "end.ply", "--any"]);
        assert_eq!((run.status, without_seconds(&run)), (status, answer));
        let run = folder.run(&["step", "start.ply", "end.ply", "--any", "--json"]);
        let json: Value = serde_json::from_str(&run.stdout).unwrap();
        assert_eq!(json["collision_free"], json!(status == 0));
        assert_eq!(json["min_distance"], 0.0);
        assert_eq!(json.as_object().unwrap().len(), 3);
    }
    let both = fall(1.0, 0.5).run(&["step", "start.ply", "end.ply", "--any", "--toi"]);
    assert_eq!(both.status, 2);
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
        run.stdout.lines().next(),
        Some("contact at t = 0.5: edge 0 (vertices 0, 1) and edge 3 (vertices 3, 4)")
    );
}

#[test]
fn a_pair_in_contact_at_the_start_is_counted() {
    let run = fall(0.0, 0.5).run(&["step", "start.ply", "end.ply"]);
    assert_eq!(run.status, 1);
    assert_eq!(
        without_seconds(&run),
        "contact at t = 0: vertex 4 and face 1 (vertices 2, 1, 3)\n\
         candidates: 4 vertex-face pairs, 3 edge-edge pairs\n\
         touching at t = 0: 1 pairs\n"
    );
}

/// The keys of a JSON object and of those in it, in their order.
fn keys(json: &str) -> Vec<&str> {
    json.match_indices("\":")
        .filter_map(|(end, _)| json[..end].rsplit('"').next())
        .collect()
}

#[test]
fn json_is_one_line_with_these_keys_in_this_order() {
    let run = fall(1.0, -2.0).run(&["step", "start.ply", "end.ply", "--json"]);
    assert_eq!(run.status, 1);
    assert_eq!(
        without_seconds(&run),
        "{\"min_distance\":0.0,\"collision_free\":false,\"toi\":0.3333333333333333,\
         \"pair\":{\"kind\":\"vf\",\"ids\":[4,1],\"distance\":{\"lower\":0.0,\"upper\":0.0}},\
         \"touching_at_start\":0,\"candidates\":{\"vf\":8,\"ee\":5,\"ve\":0,\"vv\":0},\""
    );
    assert_eq!(run.stdout.find('\n'), Some(run.stdout.len() - 1));
    assert_eq!(
        keys(&run.stdout),
        [
            "min_distance",
            "collision_free",
            "toi",
            "pair",
            "kind",
            "ids",
            "distance",
            "lower",
            "upper",
            "touching_at_start",
            "candidates",
            "vf",
            "ee",
            "ve",
            "vv",
            "seconds",
            "read",
            "broad",
            "narrow",
            "total"
        ]
    );
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
        "{\"min_distance\":0.0,\"collision_free\":true,\"toi\":null,\"pair\":null,\"touching_at_start\":0,\
         \"candidates\":{\"vf\":2,\"ee\":0,\"ve\":0,\"vv\":0},\""
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
        assert_eq!(
            without_seconds(&run),
            without_seconds(&expected),
            "{start}, {end}"
        );
    }
}

prop_compose! {
    /// Triangles without shared vertices, most of which touch during the step.
    fn triangles(count: usize)(
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
        let expected = expected(&step(&motion.mesh, &x0, &x1).unwrap());

        let folder = Folder::new();
        folder.write("start.ply", ply(&frame(&x0)));
        folder.write("end.ply", ply(&frame(&x1)));
        for threads in ["1", "2", "7"] {
            let run = folder.run(&["step", "start.ply", "end.ply", "--json", "--threads", threads]);
            let mut report: Value = serde_json::from_str(&run.stdout).unwrap();
            report.as_object_mut().unwrap().remove("seconds");
            prop_assert_eq!(&report, &expected);
            prop_assert_eq!(run.status == 0, report["collision_free"] == true);
            prop_assert_eq!(run.status == 1, report["collision_free"] == false);
        }
    }
}
