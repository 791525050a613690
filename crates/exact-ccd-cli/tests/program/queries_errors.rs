//! Query files that `exact-ccd queries` cannot use.

use exact_ccd::{Query, VertexFace};

use crate::folder::Folder;
use crate::query_rows::rows;

/// A query file with one query, line by line.
fn lines() -> Vec<String> {
    let face = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let at = |z| [[0.25, 0.25, z], face[0], face[1], face[2]];
    let query = Query::<VertexFace>::new(at(1.0), at(-1.0)).unwrap();
    rows(&query, ",1").lines().map(str::to_owned).collect()
}

const ANSWER: &str = "query,contact,count,toi\n0,1,1,0.5\n";

/// The first query is valid and is answered. The second is replaced by these lines, which lead to
/// this error.
#[track_caller]
fn assert_error(second: &[String], expected: &str) {
    let folder = Folder::new();
    folder.write("vf.csv", [&lines(), second].concat().join("\n"));
    let run = folder.run(&["queries", "--kind", "vf", "vf.csv"]);
    assert_eq!(run.stdout, ANSWER);
    assert_eq!(run.error(), expected);
}

/// As [`assert_error`], with another text in one of the lines.
#[track_caller]
fn assert_error_with(line: usize, text: &str, expected: &str) {
    let mut second = lines();
    second[line] = text.to_owned();
    assert_error(&second, expected);
}

#[test]
fn a_coordinate_that_is_no_f64() {
    assert_error_with(
        2,
        "8,8,1,3,0,8,1",
        "vf.csv, line 11: y of v2 at t = 0: 1/3 is not exactly an f64",
    );
    assert_error_with(
        4,
        "9007199254740993,1,0,8,0,8,1",
        "vf.csv, line 13: x of p at t = 1: 9007199254740993/1 is not exactly an f64",
    );
}

#[test]
fn a_coordinate_that_is_no_fraction() {
    assert_error_with(
        0,
        "0.5,1,0,8,0,8,1",
        "vf.csv, line 9: x of p at t = 0: expected an integer, found \"0.5\"",
    );
    assert_error_with(
        7,
        "0,8,0,8,nan,8,1",
        "vf.csv, line 16: z of v3 at t = 1: expected an integer, found \"nan\"",
    );
    assert_error_with(
        3,
        "0,8,1,0,0,8,1",
        "vf.csv, line 12: y of v3 at t = 0: the denominator of 1/0 is zero",
    );
}

#[test]
fn a_coordinate_too_large_even_if_rounded() {
    let folder = Folder::new();
    let mut text = lines();
    text[0] = format!("1{},1,0,8,0,8,1", "0".repeat(309));
    folder.write("vf.csv", text.join("\n"));
    let run = folder.run(&["queries", "--kind", "vf", "--round-input", "vf.csv"]);
    let error = run.error();
    assert!(
        error.starts_with("vf.csv, line 1: x of p at t = 0: 1000"),
        "{error}"
    );
    assert!(error.ends_with(" is out of the range of f64"), "{error}");
}

#[test]
fn a_query_cut_short() {
    for rows in 1..8 {
        assert_error(
            &lines()[..rows],
            &format!(
                "vf.csv, line {}: the file ends after {rows} of the 8 rows of a query",
                8 + rows
            ),
        );
    }
}

#[test]
fn a_row_with_other_columns() {
    assert_error_with(
        1,
        "0,8,0,8,0,8",
        "vf.csv, line 10: expected 7 fields, as in the first row, found 6",
    );
    assert_error_with(
        1,
        "0",
        "vf.csv, line 10: expected 7 fields, as in the first row, found 1",
    );
}

#[test]
fn an_invalid_ground_truth() {
    assert_error_with(
        1,
        "0,8,0,8,0,8,yes",
        "vf.csv, line 10: expected 0 or 1 as the ground truth, found \"yes\"",
    );
    assert_error_with(
        1,
        "0,8,0,8,0,8,0",
        "vf.csv, line 10: the ground truth is 0, expected 1 as in the first row of the query",
    );
}

#[test]
fn a_missing_file_after_a_valid_one() {
    let folder = Folder::new();
    folder.write("vf.csv", lines().join("\n"));
    let run = folder.run(&["queries", "--kind", "vf", "vf.csv", "missing.csv", "vf.csv"]);
    // Nothing is computed before all files are there.
    assert_eq!(run.stdout, "");
    assert!(run.error().starts_with("missing.csv: "), "{run:?}");
}

#[test]
fn bytes_that_are_no_text() {
    let folder = Folder::new();
    folder.write("vf.csv", b"\xff\x00,1,1,1,1,1\n");
    let run = folder.run(&["queries", "--kind", "vf", "vf.csv"]);
    assert!(
        run.error().starts_with("vf.csv, line 1: x of p at t = 0: "),
        "{run:?}"
    );
}
