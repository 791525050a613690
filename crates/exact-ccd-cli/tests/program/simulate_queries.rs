//! The queries of a simulation as a data set.

use std::fs;

use crate::folder::Folder;
use crate::simulate::folder;

/// The sums of all columns of `counts.csv` after the first.
fn counts(folder: &Folder) -> [usize; 6] {
    let text = folder.read("queries/counts.csv");
    let (header, rows) = text.split_once('\n').unwrap();
    assert_eq!(
        header,
        "step,vertex_face,vertex_face_in_contact,vertex_face_kept,\
         edge_edge,edge_edge_in_contact,edge_edge_kept"
    );
    let mut sums = [0; 6];
    for (row, step) in rows.lines().zip(1..) {
        let numbers: Vec<usize> = row.split(',').map(|number| number.parse().unwrap()).collect();
        assert_eq!(numbers[0], step);
        for (sum, number) in sums.iter_mut().zip(&numbers[1..]) {
            *sum += number;
        }
    }
    sums
}

/// The query files of a kind, in order.
fn query_files(folder: &Folder, kind: &str) -> Vec<String> {
    let name = format!("queries/{kind}");
    let entries = fs::read_dir(folder.path(&name)).unwrap();
    let mut files: Vec<String> = entries
        .map(|entry| format!("{name}/{}", entry.unwrap().file_name().to_str().unwrap()))
        .collect();
    files.sort();
    files
}

#[test]
fn queries_are_a_data_set_with_ground_truth() {
    let folder = folder();
    let run = folder.run(&[
        "simulate",
        "scene.toml",
        "--output",
        "result",
        "--dump-queries",
        "queries",
    ]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let [vf, vf_in_contact, vf_kept, ee, ee_in_contact, ee_kept] = counts(&folder);
    // All of the few queries are kept. Some steps that the line search proposes pass through the floor.
    assert!(vf == vf_kept && ee == ee_kept && vf_in_contact > 0 && ee_in_contact > 0);
    assert_eq!(
        run.stdout.lines().last(),
        Some(
            format!(
                "kept {vf} of {vf} vertex-face queries, {vf_in_contact} in contact; \
                 {ee} of {ee} edge-edge queries, {ee_in_contact} in contact"
            )
            .as_str()
        )
    );

    for (kind, name, count, in_contact) in [
        ("vf", "vertex-face", vf, vf_in_contact),
        ("ee", "edge-edge", ee, ee_in_contact),
    ] {
        let files = query_files(&folder, name);
        let arguments: Vec<&str> = ["queries", "--kind", kind]
            .into_iter()
            .chain(files.iter().map(String::as_str))
            .collect();
        let run = folder.run(&arguments);
        assert_eq!((run.status, run.stdout.lines().count()), (0, count + 1));
        assert_eq!(
            run.stderr,
            format!(
                "{count} queries, {in_contact} in contact; against the ground truth: \
                 0 false positives, 0 false negatives\n"
            )
        );
    }
    let bench = folder.run(&["bench", "queries", "--method", "exact", "--budget", "0.01"]);
    let heading = format!("### queries, vertex-face\n\n{vf} queries, {vf_in_contact} in contact");
    assert!(bench.status == 0 && bench.stdout.contains(&heading), "{bench:?}");
}

#[test]
fn the_number_of_kept_queries_is_limited() {
    let folder = folder();
    let run = folder.run(&[
        "simulate",
        "scene.toml",
        "--dump-queries",
        "queries",
        "--dump-most",
        "2",
    ]);
    assert_eq!(run.status, 0);
    let [vf, _, vf_kept, ee, _, ee_kept] = counts(&folder);
    assert!(vf_kept < vf && ee_kept < ee);
    for file in query_files(&folder, "vertex-face") {
        let text = folder.read(&file);
        let rows: Vec<&str> = text.lines().collect();
        let in_contact = rows.iter().filter(|row| row.ends_with(",1")).count();
        assert_eq!(in_contact % 8, 0);
        assert!(in_contact <= 16 && rows.len() - in_contact <= 16, "{file}");
    }
}

#[test]
fn recording_queries_does_not_change_results() {
    let folder = folder();
    for ccd in ["exact", "bisection"] {
        let observed = [
            "simulate",
            "scene.toml",
            "--method",
            ccd,
            "--overwrite",
            "--output",
            "observed",
        ];
        let observed = [observed.as_slice(), &["--dump-queries", "queries"]].concat();
        assert_eq!(folder.run(&observed).status, 0);
        let plain = [
            "simulate",
            "scene.toml",
            "--method",
            ccd,
            "--overwrite",
            "--output",
            "plain",
        ];
        assert_eq!(folder.run(&plain).status, 0);
        let read = |out: &str| fs::read(folder.path(&format!("{out}/checkpoint.json"))).unwrap();
        assert!(read("observed") == read("plain"), "{ccd}");
    }
}

#[test]
fn queries_of_an_earlier_run_stay_and_count() {
    let folder = folder();
    let whole = [
        "simulate",
        "scene.toml",
        "--output",
        "whole",
        "--dump-queries",
        "queries",
    ];
    let expected = folder.run(&whole);
    assert_eq!(expected.status, 0, "{expected:?}");
    let before = counts(&folder);
    let again = folder.run(&[
        "simulate",
        "scene.toml",
        "--output",
        "new",
        "--dump-queries",
        "queries",
    ]);
    assert!(!folder.path("new").exists());
    assert!(
        again.error().starts_with("queries: the folder has the queries"),
        "{again:?}"
    );
    assert_eq!(counts(&folder), before);

    let parts = [
        "simulate",
        "scene.toml",
        "--output",
        "parts",
        "--dump-queries",
        "parts/queries",
    ];
    let begun = folder.run(&[parts.as_slice(), &["--steps", "3"]].concat());
    assert_eq!(begun.status, 0, "{begun:?}");
    let found = folder.run(&[parts.as_slice(), &["--resume"]].concat());
    assert_eq!(found.stdout.lines().last(), expected.stdout.lines().last());
}
