//! `exact-ccd bench` on a small folder.

use std::fs;

use exact_ccd::{Query, VertexFace};

use crate::folder::Folder;
use crate::query_rows::rows;

/// A vertex that falls through a face, or beside it.
fn fall(x: f64) -> Query<VertexFace> {
    let at = |z: f64| [[x, 1.0, z], [0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    Query::<VertexFace>::new(at(1.0), at(-1.0)).unwrap()
}

fn folder() -> Folder {
    let folder = Folder::new();
    fs::create_dir_all(folder.path("data/wedge/vertex-face")).unwrap();
    let queries = rows(&fall(1.0), ",1") + &rows(&fall(8.0), ",0");
    folder.write("data/wedge/vertex-face/0.csv", queries);
    folder
}

#[test]
fn every_method_has_a_row_in_every_table() {
    let run = folder().run(&["bench", "data", "--budget", "1"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{run:?}");
    let headings: Vec<_> = run
        .stdout
        .lines()
        .filter(|line| line.starts_with("###"))
        .collect();
    assert_eq!(
        headings,
        ["### data, vertex-face", "### data, rounded, vertex-face"]
    );
    assert_eq!(run.stdout.matches("2 queries, 1 in contact.").count(), 2);
    for method in exact_ccd_methods::all() {
        let row = format!("\n| {} | all | ", method.name());
        assert_eq!(run.stdout.matches(&row).count(), 2, "{row}: {run:?}");
    }
}

#[test]
fn methods_are_chosen_by_name_and_a_report_is_written() {
    let folder = folder();
    let run = folder.run(&["bench", "data", "--method", "ti,Exact", "--output", "some/report"]);
    assert_eq!(run.status, 0, "{run:?}");
    let names: Vec<_> = run
        .stdout
        .lines()
        .filter_map(|line| line.strip_prefix("| ")?.split(" | ").next())
        .filter(|name| *name != "method")
        .collect();
    assert_eq!(names, ["exact", "TI", "exact", "TI"]);
    assert_eq!(folder.read("some/report/report.md"), run.stdout);
    assert!(folder.path("some/report/tails-data-rounded-vf.svg").exists());
}

#[test]
fn every_fault_is_reported() {
    let folder = folder();
    fs::create_dir_all(folder.path("empty")).unwrap();
    let error = |arguments: &[&str]| folder.run(&[&["bench"], arguments].concat()).error().to_owned();
    assert_eq!(
        error(&["empty"]),
        "empty: expected folders `edge-edge` or `vertex-face` with .csv or .parquet files, or `frames` with meshes"
    );
    assert!(error(&["nowhere"]).starts_with("nowhere: "));
    assert!(
        error(&["data", "--method", "exact,GUESS"])
            .starts_with("there is no method GUESS; there are exact, parity, IRF")
    );
    assert!(error(&["data", "--peer", "no-such-program"]).starts_with("no-such-program: "));
    folder.write("data/wedge/vertex-face/1.csv", "1,2,3,4,5\n");
    assert!(
        error(&["data"])
            .ends_with("1.csv, line 1: expected 3 or 6 fields, or one more for the ground truth, found 5")
    );
    folder.write("blocked", "");
    fs::remove_file(folder.path("data/wedge/vertex-face/1.csv")).unwrap();
    assert!(
        error(&["data", "--method", "exact", "--output", "blocked"]).starts_with("cannot write blocked: ")
    );
}

/// The peer writes its greeting and ends.
#[test]
fn the_run_continues_without_a_peer_that_has_failed() {
    let folder = folder();
    let greeting = r#"{"methods": [{"name": "mute", "false_negatives": true, "false_positives": true, "time": "absent", "call_ns": 1}]}"#;
    folder.write("peer.sh", format!("echo '{greeting}'\n"));
    let run = folder.run(&[
        "bench",
        "data",
        "--method",
        "exact,mute",
        "--peer",
        "sh peer.sh",
        "--output",
        "report",
    ]);
    assert_eq!(run.stdout.matches("\n| exact | all | ").count(), 2, "{run:?}");
    assert_eq!(run.stdout.matches("\n| mute | 0 + 0 | ").count(), 2, "{run:?}");
    assert_eq!(
        run.stdout
            .matches("\nmute has failed and answers no more: sh peer.sh: ")
            .count(),
        1,
        "{run:?}"
    );
    assert!(
        folder
            .read("report/report.md")
            .contains("mute has failed and answers no more")
    );
    assert_eq!(run.status, 2);
    assert!(run.stderr.contains("sh peer.sh: "), "{run:?}");
}
