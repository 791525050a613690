//! `exact-ccd queries` of curved motion.

use std::path::Path;

use exact_ccd_data::{CurvedReader, DataFolder};

use crate::folder::Folder;
use crate::queries::HEADER;

/// A vertex that passes a vertex at rest at t = 1/2 on a curve, at the distance of 1.
const PASSES: &str = r#"{"kind": "vv", "points": [[[-1, 0, 0], [0, 0, 0], [1, 0, 0]], [[0, 1, 0], [0, 1, 0], [0, 1, 0]]], "count": 0, "toi": null}"#;

/// A vertex on the x axis that turns by 180° about the z axis, through the plane x = 0, in which the face is.
const TURNS: &str = r#"{"kind": "vf", "first": [{"q0": [1, 0, 0, 0], "q1": [0, 0, 0, 1], "o0": [0, 0, 0], "o1": [0, 0, 0]}], "second": [], "points": [[1, 0, 0], [0, 0, -1], [0, 2, -1], [0, 1, 2]], "count": 1, "toi": 0.5}"#;

#[test]
fn curved_motion_has_the_columns_of_straight_motion() {
    let folder = Folder::new();
    folder.write("some.jsonl", format!("{PASSES}\n{TURNS}\n"));
    let run = folder.run(&["queries", "some.jsonl", "some.jsonl"]);
    assert_eq!(run.status, 0, "{run:?}");
    assert_eq!(
        run.stdout,
        format!("{HEADER}0,0,0,\n1,1,1,0.5\n2,0,0,\n3,1,1,0.5\n")
    );
    assert!(
        run.stderr.contains("0 false positives, 0 false negatives"),
        "{run:?}"
    );
    let run = folder.run(&["queries", "--json", "some.jsonl"]);
    let first = run.stdout.lines().next().unwrap();
    assert_eq!(first, r#"{"query":0,"contact":false,"count":0,"toi":null}"#);
    let run = folder.run(&["queries", "--min-distance", "1", "some.jsonl"]);
    assert_eq!(run.stdout.lines().nth(1), Some("0,1,1,0.5"));
}

#[test]
fn wrong_lines_and_options_are_refused() {
    let folder = Folder::new();
    folder.write(
        "some.jsonl",
        format!("{PASSES}\n{}\n", TURNS.replace("\"q1\"", "\"q2\"")),
    );
    let run = folder.run(&["queries", "some.jsonl"]);
    assert_eq!(run.status, 2, "{run:?}");
    assert!(run.stdout.starts_with(&format!("{HEADER}0,0,0,\n")), "{run:?}");
    assert!(
        run.stderr
            .contains("some.jsonl, line 2: first[0].q2 is unknown here"),
        "{run:?}"
    );
    folder.write("some.csv", "0,0,0\n");
    folder.write("empty.jsonl", "\n");
    for (arguments, message) in [
        (&["--kind", "vf", "some.jsonl"][..], "--kind does not apply"),
        (&["--method", "parity", "some.jsonl"], "needs --method exact"),
        (&["--round-input", "some.jsonl"], "--round-input does not apply"),
        (
            &["--view", "page.html", "some.jsonl"],
            "--view shows straight motion",
        ),
        (
            &["some.csv", "some.jsonl"],
            "some.csv: not a file of curved motion",
        ),
        (&["empty.jsonl"], "0 queries"),
    ] {
        let run = folder.run(&[&["queries"], arguments].concat());
        assert_eq!(run.status, 2, "{run:?}");
        assert!(run.stderr.contains(message), "{run:?}");
    }
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn answers_to_published_queries_of_curved_motion_are_their_truth() {
    let data = DataFolder::find(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))).unwrap();
    for file in data.nonlinear().unwrap() {
        let name = std::fs::canonicalize(&file).unwrap();
        let run = Folder::new().run(&["queries", name.to_str().unwrap()]);
        let answers = run.stdout.strip_prefix(HEADER).unwrap();
        let records = CurvedReader::open(&file).unwrap().map(Result::unwrap);
        let mut count = 0;
        for (index, (answer, record)) in answers.lines().zip(records).enumerate() {
            let [query, contact, number, toi] = answer.split(',').collect::<Vec<_>>()[..] else {
                panic!("{answer}")
            };
            assert_eq!(query, index.to_string());
            assert_eq!(contact == "1", record.toi.is_some(), "{name:?} {index}");
            assert_eq!(number.parse().ok(), record.count, "{name:?} {index}");
            assert_eq!(toi.parse().ok(), record.toi, "{name:?} {index}");
            count += 1;
        }
        assert!(count > 0, "{name:?}");
    }
}
