//! The methods of `exact-ccd queries`.

use exact_ccd::{CONTACT, EdgeEdge, Point, Query, VertexFace};
use exact_ccd_data::DataKind;
use exact_ccd_methods::parity::{self, Parity, Rounded};
use proptest::prelude::*;

use crate::folder::Folder;
use crate::queries::{HEADER, grid_points, miss, pass, slide};
use crate::query_rows::{file, rows};

/// The face rotates upward, in the plane z = t x, while the vertex moves along x = 1 − t at y = z =
/// 1/8: t (1 − t) = 1/8, twice.
fn pass_twice() -> Query<VertexFace> {
    Query::<VertexFace>::new(
        [[1.0, 0.125, 0.125], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        [[0.0, 0.125, 0.125], [0.0; 3], [1.0, 0.0, 1.0], [0.0, 1.0, 0.0]],
    )
    .unwrap()
}

/// Coordinates from 1 to 2 and, on one axis of the last point, one that is as far away as possible.
fn far(axis: usize) -> Query<VertexFace> {
    let t0 = [[1.0, 1.0, 1.5], [1.0; 3], [2.0, 1.0, 1.0], [1.0, 2.0, 1.0]];
    let mut t1 = t0;
    t1[3][axis] = f64::MIN;
    Query::<VertexFace>::new(t0, t1).unwrap()
}

#[test]
fn parity_does_not_distinguish_two_contacts_from_none() {
    let folder = Folder::new();
    let queries = [
        (miss(), ",0"),
        (pass(), ",1"),
        (slide(), ",1"),
        (pass_twice(), ",1"),
    ];
    folder.write(
        "vf.csv",
        queries.map(|(query, truth)| rows(&query, truth)).concat(),
    );
    for method in ["parity", "parity-rational"] {
        let run = folder.run(&["queries", "--kind", "vf", "--method", method, "vf.csv"]);
        assert_eq!(
            run.stdout,
            "query,contact,count,toi\n0,0,even,\n1,1,odd,\n2,1,boundary,\n3,0,even,\n"
        );
        assert_eq!(
            run.stderr,
            "4 queries, 2 in contact; against the ground truth: 0 false positives, 1 false negatives\n"
        );
        assert_eq!(run.status, 0);
    }
}

#[test]
fn the_method_is_exact_if_none_is_named() {
    let folder = Folder::new();
    folder.write("vf.csv", rows(&pass(), ",1") + &rows(&pass_twice(), ",0"));
    assert_eq!(
        folder.run(&["queries", "--kind", "vf", "--method", "exact", "vf.csv"]),
        folder.run(&["queries", "--kind", "vf", "vf.csv"])
    );
}

/// The vertex passes the face at a distance of 2⁻⁶⁰, which is lost when the query is shifted.
#[test]
fn only_the_rounded_method_rounds() {
    let face = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let at = |z| [[-2f64.powi(-60), 0.25, z], face[0], face[1], face[2]];
    let query = Query::<VertexFace>::new(at(1.0), at(-1.0)).unwrap();
    let folder = Folder::new();
    folder.write("vf.csv", file(&[query]));
    for (method, answer) in [("parity", "1,boundary,"), ("parity-rational", "0,even,")] {
        let run = folder.run(&["queries", "--kind", "vf", "--method", method, "vf.csv"]);
        assert_eq!(run.stdout, format!("{HEADER}0,{answer}\n"));
    }
}

#[test]
fn a_query_that_cannot_be_shifted_is_an_error_that_names_it() {
    let folder = Folder::new();
    folder.write("sound.csv", file(&[pass(), pass()]));
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        folder.write("far.csv", file(&[miss(), far(axis), pass()]));
        let run = folder.run(&[
            "queries",
            "--kind",
            "vf",
            "--method",
            "parity",
            "sound.csv",
            "far.csv",
        ]);
        assert_eq!(run.stdout, format!("{HEADER}0,1,odd,\n1,1,odd,\n2,0,even,\n"));
        assert_eq!(
            run.error(),
            format!("far.csv, query 1: on the {name} axis, the coordinates are too large to be shifted")
        );
        for method in ["exact", "parity-rational"] {
            let run = folder.run(&["queries", "--kind", "vf", "--method", method, "far.csv"]);
            assert_eq!((run.status, run.stdout.lines().count()), (0, 4), "{run:?}");
        }
    }
}

fn columns(parity: Parity) -> &'static str {
    match parity {
        Parity::Even => "0,even,",
        Parity::Odd => "1,odd,",
        Parity::Boundary => "1,boundary,",
    }
}

fn assert_answers<K: DataKind>(kind: &str, points: &[[[Point; 4]; 2]]) {
    let queries: Vec<Query<K>> = points
        .iter()
        .map(|&[t0, t1]| Query::new(t0, t1).unwrap())
        .collect();
    let folder = Folder::new();
    folder.write("q.csv", file(&queries));
    let answers = |method, parity: &dyn Fn(&Query<K>) -> Parity| {
        let run = folder.run(&["queries", "--kind", kind, "--method", method, "q.csv"]);
        let row = |(index, query)| format!("{index},{}\n", columns(parity(query)));
        let expected = HEADER.to_owned() + &queries.iter().enumerate().map(row).collect::<String>();
        assert_eq!(run.stdout, expected);
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    };
    answers("parity", &|query| Rounded::shift(query).unwrap().parity());
    answers("parity-rational", &parity::rational);
}

proptest! {
    // Each case starts the program four times.
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn parities_are_those_of_the_library(points in prop::collection::vec(grid_points(), 100)) {
        assert_answers::<VertexFace>("vf", &points);
        assert_answers::<EdgeEdge>("ee", &points);
    }
}

/// The conservative times of Tight Inclusion are early by its tolerance at most; BSC has no times.
#[test]
fn any_registered_method_answers_by_its_name_in_any_case() {
    let folder = Folder::new();
    folder.write("vf.csv", rows(&miss(), ",0") + &rows(&pass(), ",1"));
    let answers = |method: &str| {
        let run = folder.run(&["queries", "--kind", "vf", "--method", method, "vf.csv"]);
        assert_eq!(run.status, 0, "{run:?}");
        run.stdout
    };
    for name in exact_ccd_methods::names() {
        let expected = answers(&name);
        assert_eq!(answers(&name.to_lowercase()), expected);
        // Both queries are far from degenerate. Only methods with false positives may report the miss.
        let guarantees = exact_ccd_methods::by_name(&name).unwrap().guarantees();
        let is_right = expected.contains("\n0,0,") || guarantees.false_positives;
        assert!(is_right && expected.contains("\n1,1,"), "{name}: {expected}");
    }
    assert_eq!(answers("bsc"), format!("{HEADER}0,0,,\n1,1,,\n"));
    let tight_inclusion = answers("ti");
    let time: f64 = tight_inclusion
        .trim_end()
        .rsplit_once("1,1,,")
        .and_then(|(_, time)| time.parse().ok())
        .unwrap();
    let exact = pass().time_of_impact(CONTACT).unwrap();
    assert!(time <= exact && time > exact - 1e-5, "{tight_inclusion}");
}

#[test]
fn an_unknown_method_is_an_error_that_lists_the_names() {
    let folder = Folder::new();
    folder.write("vf.csv", file(&[pass()]));
    let run = folder.run(&["queries", "--kind", "vf", "--method", "guess", "vf.csv"]);
    assert_eq!((run.status, run.stdout.as_str()), (2, ""));
    for name in ["exact", "parity", "TI", "parity-rational"] {
        assert!(run.stderr.contains(name), "{run:?}");
    }
}
