//! Files of curved motion: the forms of lines, and errors.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use exact_ccd::motion::{Bezier, Chain, CurvedQuery, RigidMotion};
use exact_ccd::{AnyKind, EdgeEdge, VertexEdge, VertexVertex};
use exact_ccd_data::{CurvedReader, CurvedRecord};

const CURVES: &str = r#"{"kind": "vv", "points": [[[0, 0, 0], [1e-1, 2, -3.5]], [[4, 0, 0], [0, 0, 1]]], "count": 0, "toi": null}"#;
const BODIES: &str = r#"{"kind": "ve", "first": [{"q0": [1, 0, 0, 0], "q1": [1, 0, 0, 1], "o0": [0, 0, 0], "o1": [0, 0, 2]}], "second": [], "points": [[1, 0, 0], [0, 2, 0], [0, 0, 0.5]]}"#;

fn read(text: &str) -> Result<Vec<CurvedRecord>, String> {
    let records = CurvedReader::new("some.jsonl", text.as_bytes());
    let records: Result<_, _> = records.collect();
    records.map_err(|error: exact_ccd_data::DataError| error.to_string())
}

fn message(text: &str) -> String {
    let error = read(text).unwrap_err();
    error.strip_prefix("some.jsonl, line 1: ").unwrap().to_owned()
}

#[test]
fn curves_are_control_points_of_each_point() {
    let records = read(&format!("\n{CURVES}\r\n\n")).unwrap();
    let control = [[[0.0; 3], [4.0, 0.0, 0.0]], [[0.1, 2.0, -3.5], [0.0, 0.0, 1.0]]];
    let expected: CurvedQuery<VertexVertex> = Bezier::new(&control).unwrap().into();
    assert_eq!(records.len(), 1);
    assert_eq!(records[0].kind(), AnyKind::VertexVertex);
    assert_eq!(records[0].query(), Some(expected));
    assert_eq!(records[0].query::<EdgeEdge>(), None);
    assert_eq!((records[0].count, records[0].toi), (Some(0), None));
}

#[test]
fn bodies_have_motions() {
    let records = read(BODIES).unwrap();
    let quaternions = [[1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 1.0]];
    let motion = RigidMotion::new(quaternions, &[[0.0; 3], [0.0, 0.0, 2.0]]).unwrap();
    let points = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 0.5]];
    let expected = CurvedQuery::<VertexEdge>::of_bodies(points, motion.into(), Chain::default()).unwrap();
    assert_eq!(records[0].query(), Some(expected));
    assert_eq!((records[0].count, records[0].toi), (None, None));
}

#[test]
fn the_last_line_needs_no_end_and_an_error_is_the_last_item() {
    assert_eq!(read(&format!("{CURVES}\n{BODIES}")).unwrap().len(), 2);
    let text = format!("{CURVES}\nx\n{BODIES}");
    let mut reader = CurvedReader::new("some.jsonl", text.as_bytes());
    assert!(reader.next().unwrap().is_ok());
    let error = reader.next().unwrap().unwrap_err().to_string();
    assert_eq!(
        error,
        "some.jsonl, line 2: column 1: expected value; expected a JSON object on one line"
    );
    assert!(reader.next().is_none());
}

#[test]
fn errors_name_the_field_and_what_is_expected() {
    for (text, from, to, expected) in [
        (
            CURVES,
            CURVES,
            "[1, 2]",
            "the line: expected an object with kind, points, first, second, count, toi, found [1,2]",
        ),
        (
            CURVES,
            "\"kind\": \"vv\", ",
            "",
            "kind is missing; expected the short name of the kind of the query, such as \"vf\"",
        ),
        (
            CURVES,
            "\"vv\"",
            "\"fv\"",
            "kind: expected \"vf\", \"ee\", \"ve\", \"vv\", found \"fv\"",
        ),
        (
            CURVES,
            "\"vv\"",
            "\"ve\"",
            "points: expected 3 points in a query of the kind ve: p, a, b, found [[[0,0,0],[0.1,2,-3.5]],[[4,0,0],[0,0,1]…",
        ),
        (
            CURVES,
            "[4, 0, 0], [0, 0, 1]",
            "[4, 0, 0]",
            "points[1]: expected 2 control points, as the first point has, found [[4,0,0]]",
        ),
        (
            CURVES,
            "-3.5",
            "\"a\"",
            "points[0][1]: expected a list of 3 numbers, found [0.1,2,\\\"a\\\"]",
        ),
        (
            CURVES,
            "-3.5",
            "1e999",
            "column 53: number out of range; expected a JSON object on one line",
        ),
        (
            CURVES,
            "\"count\": 0",
            "\"count\": -2",
            "count: expected a number of contact times, or -1 for infinitely many, found -2",
        ),
        (
            CURVES,
            "null",
            "1.5",
            "toi: expected a time from 0 to 1, or null if there is no contact, found 1.5",
        ),
        (
            CURVES,
            "\"toi\"",
            "\"time\"",
            "time is unknown here; remove it, or correct its name to one of kind, points, first, second, count, toi",
        ),
        (
            BODIES,
            "\"second\": [], ",
            "",
            "second is missing; expected a list of motions; an empty list is a body at rest",
        ),
        (
            BODIES,
            "\"q1\": [1, 0, 0, 1]",
            "\"q1\": [1, 0, 1]",
            "first[0].q1: expected a list of 4 numbers, found [1,0,1]",
        ),
        (
            BODIES,
            "\"o1\"",
            "\"o2\"",
            "first[0].o2 is unknown here; remove it, or correct its name to one of q0, q1, o0, o1",
        ),
        (
            BODIES,
            "\"q1\": [1, 0, 0, 1]",
            "\"q1\": [0, 0, 0, 0]",
            "first[0]: the quaternion at t = 1 is 0; a rotation is any other quaternion, of any length",
        ),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text);
        assert_eq!(message(&changed), expected, "{changed}");
    }
}

#[test]
fn the_degree_and_the_number_of_motions_are_bounded() {
    let curve = format!("[{}]", ["[0, 0, 0]"; 10].join(", "));
    let text = format!(r#"{{"kind": "vv", "points": [{curve}, {curve}]}}"#);
    assert_eq!(
        message(&text),
        "points: a curve with 10 control points; expected 2 to 9, for degrees 1 to 8"
    );
    let start = BODIES.find("{\"q0\"").unwrap();
    let end = BODIES.find("}]").unwrap() + 1;
    let text = BODIES.replacen(&BODIES[start..end], &[&BODIES[start..end]; 9].join(", "), 1);
    assert_eq!(message(&text), "first: a chain of 9 motions; expected at most 8");
}
