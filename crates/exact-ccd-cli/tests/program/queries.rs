//! The answers of `exact-ccd queries`.

use exact_ccd::{CONTACT, ContactTime, EdgeEdge, Kind, Point, Query, VertexFace};
use proptest::prelude::*;

use crate::folder::Folder;
use crate::query_rows::rows;

pub(crate) const HEADER: &str = "query,contact,count,toi\n";

/// A vertex that moves towards the resting face (0, 0, 0), (1, 0, 0), (0, 1, 0).
fn against_resting_face(from: Point, to: Point) -> Query<VertexFace> {
    let with_face = |point| [point, [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    Query::<VertexFace>::new(with_face(from), with_face(to)).unwrap()
}

pub(crate) fn miss() -> Query<VertexFace> {
    against_resting_face([2.0, 2.0, 1.0], [2.0, 2.0, -1.0])
}

pub(crate) fn pass() -> Query<VertexFace> {
    against_resting_face([0.25, 0.25, 1.0], [0.25, 0.25, -2.0])
}

/// The vertex crosses the edge x = 0 at t = 1/2 and stays in the face.
pub(crate) fn slide() -> Query<VertexFace> {
    against_resting_face([-0.25, 0.25, 0.0], [0.25, 0.25, 0.0])
}

/// The face rotates upward, in the plane z = t x, while the vertex moves along x = 1 − t at z = 1/8:
/// t (1 − t) = 1/8, twice.
fn pass_twice() -> Query<VertexFace> {
    Query::<VertexFace>::new(
        [[1.0, 0.0, 0.125], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        [[0.0, 0.0, 0.125], [0.0; 3], [1.0, 0.0, 1.0], [0.0, 1.0, 0.0]],
    )
    .unwrap()
}

fn crossing_edges() -> Query<EdgeEdge> {
    let at = |z| [[-1.0, 0.0, z], [1.0, 0.0, z], [0.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
    Query::<EdgeEdge>::new(at(1.0), at(-1.0)).unwrap()
}

#[test]
fn each_query_has_its_row() {
    let folder = Folder::new();
    let queries = [miss(), pass(), slide(), pass_twice()];
    folder.write("vf.csv", queries.map(|query| rows(&query, "")).concat());
    let run = folder.run(&["queries", "--kind", "vf", "vf.csv"]);
    assert_eq!(
        run.stdout,
        "query,contact,count,toi\n\
         0,0,0,\n\
         1,1,1,0.3333333333333333\n\
         2,1,-1,0.5\n\
         3,1,2,0.1464466094067262\n"
    );
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
}

#[test]
fn edges_are_a_separate_kind() {
    let folder = Folder::new();
    folder.write("ee.csv", rows(&crossing_edges(), ""));
    let run = folder.run(&["queries", "--kind", "ee", "ee.csv"]);
    assert_eq!(run.stdout, HEADER.to_owned() + "0,1,1,0.5\n");
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
}

#[test]
fn blanks_and_line_breaks_do_not_matter() {
    let folder = Folder::new();
    let plain = rows(&pass(), ",1") + &rows(&miss(), ",0");
    let spacious = "\r\n \n".to_owned() + &plain.replace(',', " ,\t").replace('\n', "  \r\n\r\n");
    folder.write("plain.csv", &plain);
    folder.write("spacious.csv", spacious);
    folder.write("unended.csv", plain.trim_end());
    let expected = folder.run(&["queries", "--kind", "vf", "plain.csv"]);
    assert_eq!(
        expected.stdout,
        HEADER.to_owned() + "0,1,1,0.3333333333333333\n1,0,0,\n"
    );
    for file in ["spacious.csv", "unended.csv"] {
        assert_eq!(folder.run(&["queries", "--kind", "vf", file]), expected, "{file}");
    }
}

#[test]
fn answers_are_compared_with_the_ground_truth() {
    let folder = Folder::new();
    let right = rows(&pass(), ",1") + &rows(&miss(), ",0");
    // If the ground truth is wrong, a right answer counts as false.
    let wrong = rows(&pass(), ",0") + &rows(&slide(), ",0") + &rows(&miss(), ",1");
    folder.write("right.csv", right);
    folder.write("wrong.csv", wrong);
    folder.write("silent.csv", rows(&pass(), ""));
    let summary = |files: &[&str]| {
        let run = folder.run(&[&["queries", "--kind", "vf"], files].concat());
        assert_eq!(run.status, 0);
        run.stderr
    };
    assert_eq!(
        summary(&["right.csv"]),
        "2 queries, 1 in contact; against the ground truth: 0 false positives, 0 false negatives\n"
    );
    assert_eq!(
        summary(&["right.csv", "wrong.csv"]),
        "5 queries, 3 in contact; against the ground truth: 2 false positives, 1 false negatives\n"
    );
    assert_eq!(
        summary(&["right.csv", "silent.csv"]),
        "3 queries, 2 in contact; against the ground truth of 2 of them: 0 false positives, 0 false negatives\n"
    );
    assert_eq!(summary(&["silent.csv"]), "");
}

#[test]
fn coordinates_are_rounded_on_request() {
    let folder = Folder::new();
    // The height 1/3 instead of 1: the vertex passes at t = 1/7.
    let text = rows(&pass(), "").replacen(",8,8,8\n", ",8,1,3\n", 1);
    assert!(text.contains(",1,3\n"));
    folder.write("thirds.csv", text);
    let run = folder.run(&["queries", "--kind", "vf", "--round-input", "thirds.csv"]);
    assert_eq!(run.status, 0);
    let rounded = against_resting_face([0.25, 0.25, 1.0 / 3.0], [0.25, 0.25, -2.0]);
    let expected = rounded.time_of_impact(CONTACT).unwrap();
    assert_eq!(run.stdout, format!("{HEADER}0,1,1,{expected}\n"));
}

#[test]
fn many_queries_keep_their_order_on_any_number_of_threads() {
    let folder = Folder::new();
    folder.write("vf.csv", (rows(&miss(), "") + &rows(&pass(), "")).repeat(5_000));
    let answers = (0..5_000).map(|i| format!("{},0,0,\n{},1,1,0.3333333333333333\n", 2 * i, 2 * i + 1));
    let expected = HEADER.to_owned() + &answers.collect::<String>();
    for threads in ["1", "2", "7"] {
        let run = folder.run(&["--threads", threads, "queries", "--kind", "vf", "vf.csv"]);
        assert_eq!(run.status, 0);
        assert!(run.stdout == expected, "{threads} threads");
    }
}

/// Checks the answers to these queries against the library's, bit for bit.
fn assert_answers<K: Kind<Points = [Point; 4]>>(kind: &str, points: &[[[Point; 4]; 2]]) {
    let queries: Vec<Query<K>> = points
        .iter()
        .map(|&[start, end]| Query::new(start, end).unwrap())
        .collect();
    let folder = Folder::new();
    folder.write(
        "q.csv",
        queries.iter().map(|query| rows(query, "")).collect::<String>(),
    );
    let run = folder.run(&["queries", "--kind", kind, "q.csv"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let answers = run.stdout.strip_prefix(HEADER).unwrap();
    assert_eq!(answers.lines().count(), queries.len());
    for (index, (answer, query)) in answers.lines().zip(&queries).enumerate() {
        let [number, contact, count, toi]: [&str; 4] =
            answer.split(',').collect::<Vec<_>>().try_into().unwrap();
        let times = query.intervals(CONTACT);
        assert_eq!(number.parse(), Ok(index));
        assert_eq!(
            contact.parse(),
            Ok(i32::from(query.collides(CONTACT))),
            "{query:?}"
        );
        assert_eq!(
            count.parse(),
            Ok(times.count().map_or(-1, |count| count as i32)),
            "{query:?}"
        );
        match times.first_time().map(ContactTime::lower) {
            Some(time) => assert_eq!(toi.parse().map(f64::to_bits), Ok(time.to_bits()), "{query:?}"),
            None => assert_eq!(toi, "", "{query:?}"),
        }
    }
}

prop_compose! {
    /// Points on a coarse grid, on which degenerate queries are frequent.
    pub(crate) fn grid_points()(
        eighths in prop::array::uniform2(prop::array::uniform4(prop::array::uniform3(-3i8..=3)))
    ) -> [[Point; 4]; 2] {
        eighths.map(|points| points.map(|point| point.map(|x| f64::from(x) / 8.0)))
    }
}

proptest! {
    // Each case starts the program twice.
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn answers_are_those_of_the_library(points in prop::collection::vec(grid_points(), 200)) {
        assert_answers::<VertexFace>("vf", &points);
        assert_answers::<EdgeEdge>("ee", &points);
    }
}
