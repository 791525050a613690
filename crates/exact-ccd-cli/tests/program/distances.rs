//! `exact-ccd step` and `exact-ccd audit` with a minimum distance.

use exact_ccd::{AnyKind, Options, Separation};
use exact_ccd_mesh::{CandidateOptions, Detector, Frame, MinDistance, Point, StepReport};
use proptest::prelude::*;
use serde_json::{Value, json};

use crate::folder::{Folder, Run};
use crate::meshes::{fall, ply, tip_above_square};
use crate::step::{answer, triangles};

/// A run of `step` with these options.
fn step(folder: &Folder, options: &[&str]) -> Run {
    folder.run(&[&["step", "start.ply", "end.ply"], options].concat())
}

#[track_caller]
fn json_of(run: &Run) -> Value {
    serde_json::from_str(&run.stdout).unwrap()
}

/// A vertex that starts within the distance, of a face and of a half space.
#[test]
fn an_inner_distance_that_is_not_smaller_changes_nothing() {
    let folder = fall(0.25, -1.0);
    let half_space = [
        "--half-space",
        "0,0,0,0,0,1",
        "--no-seconds",
        "--min-distance",
        "0.5",
    ];
    let without = step(&folder, &half_space);
    assert_eq!(without.status, 1);
    for inner in ["0.5", "2"] {
        let with = step(&folder, &[&half_space[..], &["--inner-distance", inner]].concat());
        assert_eq!(with, without, "{inner}");
    }
}

#[test]
fn primitives_at_the_distance_touch() {
    let folder = fall(1.0, -1.0);
    let run = step(&folder, &["--min-distance", "0.5"]);
    assert_eq!(run.status, 1);
    assert!(
        answer(&run).starts_with(
            "minimum distance: 0.5\n\
             contact at t = 0.25: vertex 4 and face 1 (vertices 2, 1, 3), 0.5 apart\n\
             candidate pairs: "
        ),
        "{run:?}"
    );
    let run = step(&folder, &["--min-distance", "0.5", "--toi"]);
    assert_eq!(
        answer(&run),
        "minimum distance: 0.5\ncontact at t = 0.25: vertex 4 and face 1 (vertices 2, 1, 3), 0.5 apart\n"
    );
    // The tip stops at the distance, or just before it.
    for (d, status) in [(0.5, 1), (0.5f64.next_down(), 0)] {
        for mode in [&[][..], &["--toi"], &["--any"]] {
            let run = step(
                &fall(1.0, 0.5),
                &[&["--min-distance", &d.to_string()], mode].concat(),
            );
            assert_eq!(run.status, status, "{run:?}");
        }
    }
}

/// The tip starts at 1/4 above one face, and 0.306 from the other one.
#[test]
fn pairs_that_start_within_the_distance_are_counted() {
    let folder = fall(0.25, 1.0);
    let run = step(&folder, &["--min-distance", "0.275", "--json"]);
    assert_eq!(run.status, 1);
    let report = json_of(&run);
    assert_eq!(
        (&report["min_distance"], &report["toi"]),
        (&json!(0.275), &json!(0.0))
    );
    assert_eq!(report.get("inner_distance"), None);
    let contact = &report["contact"];
    assert_eq!(
        json!([contact["kind"], contact["ids"], contact["distance"]]),
        json!(["vf", [4, 1], {"lower": 0.25, "upper": 0.25}])
    );
    let count = report["touching_at_start"].as_u64().unwrap();
    assert!(count >= 1, "{report}");
    let run = step(&folder, &["--min-distance", "0.275"]);
    assert!(run.stdout.contains("contact at t = 0: vertex 4"), "{run:?}");
    assert!(
        run.stdout
            .contains(&format!("pairs within the minimum distance at t = 0: {count}\n")),
        "{run:?}"
    );
}

#[test]
fn pairs_that_start_within_the_distance_may_have_another_one() {
    let distances = ["--min-distance", "0.5", "--inner-distance", "0.125"];
    let with = |mode: &[&'static str]| [&distances, mode].concat();
    let mut counts = Vec::new();
    // The tip starts at 1/4. It goes up and comes back, stays above 1/8, or falls through it.
    for (end, toi) in [
        (1.0, None),
        (0.1875, None),
        (0.125, Some(1.0)),
        (-0.25, Some(0.25)),
    ] {
        let folder = fall(0.25, end);
        for mode in [&[][..], &["--toi"], &["--any"]] {
            let run = step(&folder, &with(mode));
            assert_eq!(run.status, i32::from(toi.is_some()), "{run:?}");
        }
        let report = json_of(&step(&folder, &with(&["--json"])));
        assert_eq!(
            (&report["toi"], &report["inner_distance"]),
            (&json!(toi), &json!(0.125))
        );
        counts.push(report["touching_at_start"].as_u64().unwrap());
    }
    // The distances at the start do not depend on the end.
    assert!(
        counts[0] >= 1 && counts.iter().all(|&count| count == counts[0]),
        "{counts:?}"
    );

    let run = step(&fall(0.25, -0.25), &with(&["--toi"]));
    assert_eq!(
        answer(&run),
        "minimum distance: 0.5, and 0.125 for pairs that start within it\n\
         contact at t = 0.25: vertex 4 and face 1 (vertices 2, 1, 3), 0.125 apart\n"
    );
}

/// Two rods and a point, at the height z above the first rod, in the order of the vertices.
fn rods(point: f64, rod: f64) -> String {
    let positions = [
        [0.0, -4.0, 0.0],
        [0.0, 4.0, 0.0],
        [-4.0, 2.0, rod],
        [4.0, 2.0, rod],
        [0.0, 0.0, point],
    ];
    let vertex = |[x, y, z]: &Point| format!("v {x} {y} {z}\n");
    positions.iter().map(vertex).collect::<String>() + "l 1 2\nl 3 4\np 5\n"
}

#[test]
fn loose_vertices_and_edges_have_pairs_of_their_own() {
    let folder = Folder::new();
    let report = |start: String, end: String| {
        folder.write("start.obj", start);
        folder.write("end.obj", end);
        let run = folder.run(&["step", "start.obj", "end.obj", "--min-distance", "1", "--points"]);
        answer(&run)
    };
    let text = report(rods(3.0, 9.0), rods(-1.0, 9.0));
    assert!(
        text.contains("contact at t = 0.5: vertex 4 and edge 0 (vertices 0, 1), 1 apart\n"),
        "{text}"
    );
    assert!(text.contains(" vertex-edge, 0 vertex-vertex\n"), "{text}");
    let points = |z: f64| format!("v 0 0 0\nv 0 0 {z}\np 1\np 2\n");
    assert_eq!(
        report(points(3.0), points(-1.0)),
        "points alone: there is neither a face nor an edge, so the answer is about points\n\
         minimum distance: 1\n\
         contact at t = 0.5: vertex 0 and vertex 1, 1 apart\n\
         candidate pairs: 0 vertex-face, 0 edge-edge, 0 vertex-edge, 1 vertex-vertex\n\
         pairs in contact: 0 vertex-face, 0 edge-edge, 0 vertex-edge, 1 vertex-vertex\n\
         pairs within the minimum distance at t = 0: 0\n"
    );
}

#[test]
fn an_audit_certifies_the_distance() {
    let folder = Folder::new();
    for (frame, height) in [1.0, 0.75, 0.25].into_iter().enumerate() {
        folder.write(&format!("{frame}.ply"), ply(&tip_above_square(height)));
    }
    let audit_within =
        |d, arguments: &[&str]| folder.run(&[&["audit", "--min-distance", d], arguments].concat());
    let audit = |arguments: &[&str]| audit_within("0.5", arguments);
    let run = audit(&["0.ply", "1.ply"]);
    assert_eq!(
        (run.status, answer(&run).as_str()),
        (
            0,
            "minimum distance: 0.5\nfree of contact\nframes: 2 of 2 examined\n"
        )
    );
    let run = audit(&["0.ply", "1.ply", "2.ply"]);
    assert_eq!(
        (run.status, answer(&run).as_str()),
        (
            1,
            "minimum distance: 0.5\n\
             contact between frame 1 (1.ply) and frame 2 (2.ply) at t = 0.5: vertex 4 and face 1 \
             (vertices 2, 1, 3), 0.5 apart\n\
             frames: 3 of 3 examined\n"
        )
    );
    let run = audit_within("0.275", &["2.ply"]);
    assert_eq!(
        (run.status, answer(&run).as_str()),
        (
            1,
            "minimum distance: 0.275\n\
             contact in frame 0 (2.ply): vertex 4 and face 1 (vertices 2, 1, 3), 0.25 apart\n\
             frames: 1 of 1 examined\n"
        )
    );
    let report = json_of(&audit_within("0.275", &["--json", "2.ply"]));
    assert_eq!(report["min_distance"], 0.275);
    assert_eq!(
        report["contact"]["distance"],
        json!({"lower": 0.25, "upper": 0.25})
    );
}

#[test]
fn a_distance_that_is_none_is_an_error_with_the_reason() {
    let folder = fall(1.0, 0.5);
    for (d, reason) in [
        ("-1", "distance -1 is not a finite number of at least 0"),
        ("inf", "distance inf is not a finite number of at least 0"),
        ("nan", "distance NaN is not a finite number of at least 0"),
        ("1mm", "expected a number"),
    ] {
        for (option, arguments) in [
            (
                "--min-distance",
                &["step", "start.ply", "end.ply", "--min-distance", d][..],
            ),
            (
                "--inner-distance",
                &[
                    "step",
                    "start.ply",
                    "end.ply",
                    "--min-distance",
                    "1",
                    "--inner-distance",
                    d,
                ],
            ),
            ("--min-distance", &["audit", "start.ply", "--min-distance", d]),
        ] {
            let run = folder.run(arguments);
            assert_eq!((run.status, run.stdout.as_str()), (2, ""));
            let expected = format!("error: invalid value '{d}' for '{option} <D>': {reason}\n");
            assert!(run.stderr.starts_with(&expected), "{run:?}");
        }
    }
}

proptest! {
    // Each case starts the program a few times.
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn the_answer_within_a_distance_is_that_of_the_library(
        x0 in triangles(4),
        x1 in triangles(4),
        d in 0.0..0.25,
        inner in prop::option::of(0.0..0.25),
    ) {
        let faces = (0..4).map(|face| [0, 1, 2].map(|corner| 3 * face + corner));
        let frame = |x: &[Point]| Frame::new(x.to_vec(), faces.clone().collect()).unwrap();
        let folder = Folder::new();
        folder.write("start.ply", ply(&frame(&x0)));
        folder.write("end.ply", ply(&frame(&x1)));

        let separation = |d| Separation::new(d).unwrap();
        let mut distance = MinDistance::uniform(separation(d));
        if let Some(inner) = inner {
            distance = distance.with_inner(separation(inner));
        }
        let start = frame(&x0);
        let motion = exact_ccd_mesh::Motion::new(frame(&x0), frame(&x1)).unwrap();
        let options = CandidateOptions::default().with_min_distance(distance.clone());
        let report =
            StepReport::with_options(motion.step().unwrap(), &exact_ccd_mesh::Bvh, &options, &|_| ()).unwrap();
        let earliest = Detector::new(start.mesh).collision(&x0, &x1, Options::within(distance)).unwrap();
        prop_assert_eq!(earliest, report.earliest);

        let [outer, within] = [d, inner.unwrap_or(d)].map(|d| d.to_string());
        let mut options = vec!["--min-distance", &outer];
        if inner.is_some() {
            options.extend(["--inner-distance", &within]);
        }
        let run = step(&folder, &[&options[..], &["--json"]].concat());
        prop_assert_eq!(run.status, i32::from(earliest.is_some()));
        let json = json_of(&run);
        prop_assert_eq!(&json["toi"], &json!(report.time_of_impact()));
        prop_assert_eq!(&json["touching_at_start"], &json!(report.touching.total()));
        prop_assert_eq!(&json["candidates"]["vf"], &json!(report.candidates[AnyKind::VertexFace]));
        if let Some(contact) = earliest {
            let distance = json!({"lower": contact.distance.lower, "upper": contact.distance.upper});
            prop_assert_eq!(&json["contact"]["distance"], &distance);
        }
        for mode in ["--toi", "--any"] {
            let again = step(&folder, &[&options[..], &[mode, "--json"]].concat());
            prop_assert_eq!(again.status, run.status);
            if mode == "--toi" {
                prop_assert_eq!(&json_of(&again)["contact"], &json["contact"]);
            }
        }
    }
}
