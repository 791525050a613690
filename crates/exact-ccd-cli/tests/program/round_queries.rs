//! The output of `exact-ccd round` for query files.

use exact_ccd::{EdgeEdge, Point, Query, VertexFace};
use exact_ccd_data::DataKind;
use exact_ccd_mesh::Aabb;
use exact_ccd_methods::parity::{Displacement, Rounded};
use proptest::prelude::*;

use crate::folder::Folder;
use crate::queries::{miss, pass, slide};
use crate::query_rows::{file, points_in, rows};
use crate::rounding_report::{Report, assert_drawn};

/// One displacement for all points.
fn shared(points: &[[[Point; 4]; 2]]) -> Displacement {
    let bounds: Aabb = points.as_flattened().as_flattened().iter().copied().collect();
    Displacement::of_box(bounds.lower, bounds.upper)
}

fn errors(displacement: Displacement, points: &[[Point; 4]; 2]) -> Vec<f64> {
    let errors = points
        .as_flattened()
        .iter()
        .flat_map(|&point| displacement.error(point));
    errors.collect()
}

#[test]
fn the_report_has_displacement_and_errors() {
    let mut points = *pass().points();
    // 1 is added to x: 2⁻⁵⁴ and 2⁻⁶⁰ are lost.
    points[0][0][0] = 2f64.powi(-54);
    points[1][0][0] = 2f64.powi(-60);
    let folder = Folder::new();
    folder.write(
        "vf.csv",
        file(&[Query::<VertexFace>::new(points[0], points[1]).unwrap()]),
    );
    let run = folder.run(&["round", "--kind", "vf", "vf.csv"]);
    assert_eq!(
        run.stdout,
        format!(
            "displacement along x, y, z: 1, 1, 5\n\
             rounding errors |x + e - fl(x + e)| of 24 coordinates, at most 5.551115123125783e-17:\n\
             {:>14}  22  {}\n1e-19 to 1e-18   1  ###\n1e-17 to 1e-16   1  ###\n",
            0,
            "#".repeat(50)
        )
    );
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
}

#[test]
fn errors_of_all_magnitudes_have_their_bars() {
    let mut points = *pass().points();
    // e is a little more than 2¹⁰²², so that x is lost or rounded by up to half a unit in the last
    // place of that.
    let x = [-2f64.powi(1021), 1e-322, 1e-160, 1.5, 7e160, 2f64.powi(968)];
    for (point, x) in points.as_flattened_mut().iter_mut().zip(x) {
        point[0] = x;
    }
    let query = Query::<VertexFace>::new(points[0], points[1]).unwrap();
    let folder = Folder::new();
    folder.write("vf.csv", file(&[query]));
    let report = Report::of(&folder.run(&["round", "--kind", "vf", "vf.csv", "--plot", "plot.svg"]));
    report.assert_counts(&errors(shared(&[points]), &points));
    assert_eq!(report.rows.len(), 6);
    assert_drawn(&folder.read("plot.svg"), &report.rows);
}

#[test]
fn several_files_have_one_displacement_and_one_output() {
    let folder = Folder::new();
    folder.write("a.csv", rows(&miss(), ",0"));
    folder.write("b.csv", rows(&slide(), ""));
    let run = folder.run_with_input(
        &[
            "round",
            "--kind",
            "vf",
            "a.csv",
            "-",
            "b.csv",
            "--output",
            "rounded.csv",
        ],
        &rows(&pass(), ",1"),
    );
    let points = [miss(), pass(), slide()].map(|query| *query.points());
    let displacement = shared(&points);
    let report = Report::of(&run);
    assert_eq!(report.displacement, displacement.along_axes());
    let expected = points.map(|times| times.map(|points| points.map(|point| displacement.apply(point))));
    assert_eq!(points_in::<VertexFace>(&folder, "rounded.csv"), expected);
}

#[test]
fn no_queries_are_no_error() {
    let folder = Folder::new();
    folder.write("empty.csv", "");
    for arguments in [
        &["round", "--kind", "ee", "empty.csv"][..],
        &["round", "--kind", "ee", "empty.csv", "--per-query"],
    ] {
        let run = folder.run(&[arguments, &["--output", "rounded.csv", "--plot", "plot.svg"]].concat());
        let report = Report::of(&run);
        assert_eq!(report.displacement, [0.0; 3]);
        report.assert_counts(&[]);
        assert_eq!(folder.read("rounded.csv"), "");
        assert_drawn(&folder.read("plot.svg"), &[]);
    }
}

prop_compose! {
    /// Coordinates of very different magnitudes, in half of the cases of one sign.
    fn points(count: usize)(
        coordinates in prop::collection::vec(
            prop::array::uniform2(prop::array::uniform4(prop::array::uniform3((-1.0..1.0, -70..10)))),
            count,
        ),
        signed in any::<bool>(),
    ) -> Vec<[[Point; 4]; 2]> {
        let coordinate = |(mantissa, exponent): (f64, i32)| {
            if signed { mantissa * 2f64.powi(exponent) } else { 1.5 + mantissa / 4.0 }
        };
        let points = |points: [[(f64, i32); 3]; 4]| points.map(|point| point.map(coordinate));
        coordinates.into_iter().map(|times| times.map(points)).collect()
    }
}

fn queries<K: DataKind>(points: &[[[Point; 4]; 2]]) -> Vec<Query<K>> {
    points
        .iter()
        .map(|&[t0, t1]| Query::new(t0, t1).unwrap())
        .collect()
}

fn assert_shared<K: DataKind>(kind: &str, points: &[[[Point; 4]; 2]]) {
    let folder = Folder::new();
    folder.write("q.csv", file(&queries::<K>(points)));
    let round = |input, output| {
        folder.run(&[
            "round", "--kind", kind, input, "--output", output, "--plot", "plot.svg",
        ])
    };
    let report = Report::of(&round("q.csv", "rounded.csv"));
    let displacement = shared(points);
    assert_eq!(report.name, "displacement");
    assert_eq!(report.displacement, displacement.along_axes());
    let errors: Vec<_> = points
        .iter()
        .flat_map(|points| errors(displacement, points))
        .collect();
    report.assert_counts(&errors);
    assert_drawn(&folder.read("plot.svg"), &report.rows);

    let rounded = points_in::<K>(&folder, "rounded.csv");
    let apply = |times: &[[Point; 4]; 2]| times.map(|points| points.map(|point| displacement.apply(point)));
    assert_eq!(rounded, points.iter().map(apply).collect::<Vec<_>>());
    for query in queries::<K>(&rounded) {
        assert!(Rounded::check(query).is_ok(), "{query:?}");
    }

    let again = Report::of(&round("rounded.csv", "again.csv"));
    assert_eq!(again.displacement, [0.0; 3]);
    again.assert_counts(&vec![0.0; errors.len()]);
    assert_eq!(folder.read("again.csv"), folder.read("rounded.csv"));
}

fn assert_per_query<K: DataKind>(kind: &str, points: &[[[Point; 4]; 2]]) {
    let folder = Folder::new();
    let queries = queries::<K>(points);
    folder.write("q.csv", file(&queries));
    let run = folder.run(&[
        "round",
        "--kind",
        kind,
        "--per-query",
        "q.csv",
        "--output",
        "rounded.csv",
    ]);
    let report = Report::of(&run);
    let displacements: Vec<_> = queries.iter().map(Displacement::of_query).collect();
    assert_eq!(report.name, "largest displacements");
    for axis in 0..3 {
        let along = displacements
            .iter()
            .map(|displacement| displacement.along_axes()[axis]);
        assert_eq!(report.displacement[axis], along.fold(0.0, f64::max));
    }
    let errors = displacements
        .iter()
        .zip(points)
        .flat_map(|(displacement, points)| errors(*displacement, points));
    report.assert_counts(&errors.collect::<Vec<_>>());
    let expected = queries
        .iter()
        .map(|query| *Rounded::shift(query).unwrap().query().points());
    assert_eq!(
        points_in::<K>(&folder, "rounded.csv"),
        expected.collect::<Vec<_>>()
    );
}

proptest! {
    // Each case starts the program a few times.
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn all_queries_are_moved_by_the_displacement_of_their_box(points in points(20)) {
        assert_shared::<VertexFace>("vf", &points);
        assert_shared::<EdgeEdge>("ee", &points);
    }

    #[test]
    fn each_query_is_moved_by_its_own_displacement_on_request(points in points(20)) {
        assert_per_query::<VertexFace>("vf", &points);
        assert_per_query::<EdgeEdge>("ee", &points);
    }
}
