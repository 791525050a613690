//! `exact-ccd queries --min-distance`, and the kinds of query without faces.

use std::path::Path;

use exact_ccd::{EdgeEdge, Kind, Point, Query, Separation, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_data::{ColumnReader, DataFolder, TimesWithin};
use proptest::prelude::*;

use crate::folder::Folder;
use crate::queries::{HEADER, grid_points, miss, pass};
use crate::query_rows::file;

/// A vertex that moves along z, at this distance from an edge at rest along y.
fn past_edge(x: f64, from: f64, to: f64) -> Query<VertexEdge> {
    let at = |z| [[x, 0.0, z], [0.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
    Query::<VertexEdge>::new(at(from), at(to)).unwrap()
}

/// A vertex that moves along z towards one at rest.
fn fall(to: f64) -> Query<VertexVertex> {
    Query::<VertexVertex>::new([[0.0, 0.0, 1.0], [0.0; 3]], [[0.0, 0.0, to], [0.0; 3]]).unwrap()
}

/// The answers of the program to the queries in a file.
#[track_caller]
fn answers(folder: &Folder, kind: &str, d: &str, file: &str) -> String {
    let run = folder.run(&["queries", "--kind", kind, "--min-distance", d, file]);
    assert_eq!(run.status, 0, "{run:?}");
    run.stdout.strip_prefix(HEADER).unwrap().to_owned()
}

/// The vertex comes within 5 of the edge from z = −8 to 8 at z = −4, where 3² + 4² = 5².
#[test]
fn the_count_is_that_of_intervals() {
    let folder = Folder::new();
    folder.write(
        "ve.csv",
        file(&[past_edge(3.0, -8.0, 8.0), past_edge(6.0, -8.0, 8.0)]),
    );
    assert_eq!(answers(&folder, "ve", "5", "ve.csv"), "0,1,1,0.25\n1,0,0,\n");
    assert_eq!(answers(&folder, "ve", "0", "ve.csv"), "0,0,0,\n1,0,0,\n");
    folder.write("vf.csv", file(&[miss(), pass()]));
    assert_eq!(
        answers(&folder, "vf", "0.5", "vf.csv"),
        "0,0,0,\n1,1,1,0.16666666666666666\n"
    );
}

#[test]
fn a_vertex_that_stops_at_the_distance_touches() {
    let folder = Folder::new();
    folder.write("vv.csv", file(&[fall(0.5), fall(0.5f64.next_up()), fall(0.0)]));
    assert_eq!(
        answers(&folder, "vv", "0.5", "vv.csv"),
        "0,1,1,1\n1,0,0,\n2,1,1,0.5\n"
    );
    assert_eq!(answers(&folder, "vv", "0", "vv.csv"), "0,0,0,\n1,0,0,\n2,1,1,1\n");
}

/// The ground truth counts as the answer for the distance.
#[test]
fn answers_within_a_distance_are_compared_with_the_ground_truth() {
    let folder = Folder::new();
    let rows = String::from_utf8(file(&[fall(0.5)])).unwrap();
    folder.write("vv.csv", rows.replace('\n', ",1\n"));
    for (d, missed) in [("0.5", 0), ("0.25", 1)] {
        let run = folder.run(&["queries", "--kind", "vv", "--min-distance", d, "vv.csv"]);
        assert_eq!(
            run.stderr,
            format!(
                "1 queries, {} in contact; against the ground truth: 0 false positives, {missed} false negatives\n",
                1 - missed
            )
        );
    }
}

#[test]
fn a_distance_that_is_none_is_an_error_with_the_reason() {
    let folder = Folder::new();
    folder.write("vv.csv", "");
    for (d, reason) in [
        ("-1", "distance -1 is not a finite number of at least 0"),
        ("-inf", "distance -inf is not a finite number of at least 0"),
        ("1e999", "distance inf is not a finite number of at least 0"),
        ("NaN", "distance NaN is not a finite number of at least 0"),
        ("thin", "expected a number"),
    ] {
        let run = folder.run(&["queries", "--kind", "vv", "--min-distance", d, "vv.csv"]);
        assert_eq!((run.status, run.stdout.as_str()), (2, ""));
        let expected = format!("error: invalid value '{d}' for '--min-distance <D>': {reason}\n");
        assert!(run.stderr.starts_with(&expected), "{run:?}");
    }
}

#[test]
fn other_methods_have_neither_distances_nor_kinds_without_surfaces() {
    let folder = Folder::new();
    folder.write("q.csv", "0,0,0\n".repeat(8));
    for method in ["parity", "parity-rational", "TI", "MSRF"] {
        let run = |kind, d| {
            folder.run(&[
                "queries",
                "--kind",
                kind,
                "--method",
                method,
                "--min-distance",
                d,
                "q.csv",
            ])
        };
        assert_eq!(run("vf", "0").status, 0);
        assert_eq!(
            run("vf", "1e-3").error(),
            format!("--min-distance above 0 needs --method exact: the method {method} decides contact")
        );
        assert_eq!(
            run("ve", "0").error(),
            format!("--kind ve needs --method exact: the method {method} has the kinds vf and ee")
        );
    }
}

#[test]
fn a_query_of_another_kind_is_cut_short() {
    let folder = Folder::new();
    folder.write("q.csv", file(&[fall(0.5)]));
    for (kind, rows) in [("ve", 6), ("vf", 8)] {
        let run = folder.run(&["queries", "--kind", kind, "q.csv"]);
        let expected = format!("q.csv, line 4: the file ends after 4 of the {rows} rows of a query");
        assert_eq!(run.error(), expected);
    }
}

/// The program converts the queries to Parquet and back to the same bytes.
#[track_caller]
fn assert_converts<K: Kind + PartialEq>(queries: &[Query<K>]) {
    let folder = Folder::new();
    folder.write("q.csv", file(queries));
    for (from, to) in [("q.csv", "q.parquet"), ("q.parquet", "again.csv")] {
        let run = folder.run(&["convert", "--kind", K::KIND.short(), from, "-o", to]);
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    }
    assert_eq!(folder.read("again.csv"), folder.read("q.csv"));
    let records = ColumnReader::<K>::open(&folder.path("q.parquet")).unwrap();
    let read: Vec<_> = records.map(|record| record.unwrap().sample.query).collect();
    assert_eq!(read, queries);
    let run = |name| answers(&folder, K::KIND.short(), "0.5", name);
    assert_eq!(run("q.parquet"), run("q.csv"));
}

#[test]
fn all_kinds_convert_to_columns_and_back() {
    assert_converts(&[miss(), pass()]);
    assert_converts(&[past_edge(3.0, -8.0, 8.0), past_edge(0.1, 1e-300, 5e-324)]);
    assert_converts(&[fall(0.5), fall(0.1), fall(0.0)]);
}

#[test]
fn a_scene_has_no_queries_of_loose_vertices() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("fall")).unwrap();
    let run = folder.run(&["convert", "--kind", "vv", "fall", "-o", "q.parquet"]);
    assert_eq!(
        run.error(),
        "fall: a folder is a scene, which has queries of the kinds vf and ee, not vv"
    );
}

/// Checks the answers to these queries within a distance against the library's, bit for bit.
fn assert_answers<K: Kind>(points: &[[[Point; 4]; 2]], d: f64) {
    let queries: Vec<Query<K>> = points
        .iter()
        .map(|points| {
            let [t0, t1] = points.map(|points| {
                let mut first = K::Points::default();
                first
                    .as_mut()
                    .copy_from_slice(&points[..K::KIND.point_names().len()]);
                first
            });
            Query::new(t0, t1).unwrap()
        })
        .collect();
    let folder = Folder::new();
    folder.write("q.csv", file(&queries));
    let d = Separation::new(d).unwrap();
    let expected = queries.iter().enumerate().map(|(index, query)| {
        let intervals = query.intervals(d);
        let toi = query.time_of_impact(d).map(f64::to_bits);
        (index, query.collides(d), intervals.len(), toi)
    });
    let text = answers(&folder, K::KIND.short(), &d.get().to_string(), "q.csv");
    assert_eq!(rows(&text), expected.collect::<Vec<_>>(), "{}", K::KIND.short());
}

/// The rows of the answers, with the bits of the times.
fn rows(text: &str) -> Vec<(usize, bool, usize, Option<u64>)> {
    let row = |line: &str| {
        let [query, contact, count, toi]: [&str; 4] = line.split(',').collect::<Vec<_>>().try_into().unwrap();
        let toi = (!toi.is_empty()).then(|| toi.parse::<f64>().unwrap().to_bits());
        (
            query.parse().unwrap(),
            contact == "1",
            count.parse().unwrap(),
            toi,
        )
    };
    text.lines().map(row).collect()
}

proptest! {
    // Each case starts the program four times.
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn answers_within_a_distance_are_those_of_the_library(
        points in prop::collection::vec(grid_points(), 50),
        eighths in 1u8..8,
    ) {
        let d = f64::from(eighths) / 16.0;
        assert_answers::<VertexFace>(&points, d);
        assert_answers::<EdgeEdge>(&points, d);
        assert_answers::<VertexEdge>(&points, d);
        assert_answers::<VertexVertex>(&points, d);
    }
}

/// All published queries of a kind with the times within a distance, one run of the program for each file.
fn assert_truth<K: Kind>(expected_files: usize) {
    let data = DataFolder::find(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))).unwrap();
    let files = data.separation::<K>().unwrap();
    assert_eq!(files.len(), expected_files);
    for separation in files {
        let name = std::fs::canonicalize(&separation.queries).unwrap();
        let name = name.to_str().unwrap();
        let d = separation.d.get();
        let run = Folder::new().run(&[
            "queries",
            "--kind",
            K::KIND.short(),
            "--min-distance",
            &d.to_string(),
            name,
        ]);
        assert_eq!(run.status, 0, "{run:?}");
        assert!(
            run.stderr
                .ends_with("against the ground truth: 0 false positives, 0 false negatives\n"),
            "{name}: {}",
            run.stderr
        );
        let count = |times: &TimesWithin| {
            let lasts = times.intervals.iter().any(|[start, end]| start < end);
            // Of contact, the answer has the number of times, or −1 for an interval.
            if d == 0.0 && lasts { -1 } else { times.count as i64 }
        };
        let mut truth = separation.times().unwrap().into_iter().peekable();
        let lines = run.stdout.strip_prefix(HEADER).unwrap().lines();
        for (query, line) in lines.enumerate() {
            let [number, contact, found, toi]: [&str; 4] =
                line.split(',').collect::<Vec<_>>().try_into().unwrap();
            let place = format!("query {query} of {name}");
            assert_eq!(number.parse(), Ok(query), "{place}");
            match truth.next_if(|times| times.query == query) {
                None => assert_eq!((contact, found, toi), ("0", "0", ""), "{place}"),
                Some(times) => {
                    assert_eq!((contact, found.parse()), ("1", Ok(count(&times))), "{place}");
                    assert_eq!(toi.parse().map(f64::to_bits), Ok(times.toi.to_bits()), "{place}");
                }
            }
        }
        assert!(truth.next().is_none(), "{name}");
    }
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn answers_agree_with_the_published_times_within_a_distance() {
    assert_truth::<VertexFace>(10);
    assert_truth::<EdgeEdge>(10);
    assert_truth::<VertexEdge>(11);
    assert_truth::<VertexVertex>(11);
}
