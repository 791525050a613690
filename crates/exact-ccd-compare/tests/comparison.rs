//! Comparisons of methods on generated queries.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::fs;
use std::path::Path;
use std::time::Duration;

use exact_ccd::{CONTACT, Ccd, Decide, EdgeEdge, Exact, Guarantees, Kind, Query, TimeGuarantee, VertexFace};
use exact_ccd_compare::{Comparison, Contestant, Report, Source, Subject, Subjects, Table};
use exact_ccd_data::{DataKind, QueryWriter, Record, Sample, Seventh};

/// Points that move at random, with coordinates in 64ths, which are fast for the exact method.
fn queries<K: DataKind>(count: usize) -> Vec<Query<K>> {
    let mut random = fastrand::Rng::with_seed(7);
    let mut points = || [(); 4].map(|()| [(); 3].map(|()| f64::from(random.i32(-64..=64)) / 64.0));
    (0..count)
        .map(|_| Query::new(points(), points()).unwrap())
        .collect()
}

/// A method whose decisions are all wrong, with times that are too late.
struct Liar;

impl<K: Kind> Decide<K> for Liar {
    fn collides(&self, query: &Query<K>) -> bool {
        !query.collides(CONTACT)
    }

    fn time_of_impact(&self, query: &Query<K>) -> Option<f64> {
        self.collides(query).then_some(2.0)
    }
}

impl Ccd for Liar {
    fn name(&self) -> &'static str {
        "liar"
    }

    fn guarantees(&self) -> Guarantees {
        Guarantees {
            false_negatives: true,
            false_positives: true,
            time: TimeGuarantee::Approximate,
        }
    }
}

fn comparison(methods: Vec<Box<dyn Ccd>>, budget: Duration) -> Comparison {
    Comparison::new(methods.into_iter().map(Contestant::Method).collect(), budget)
}

fn subjects<K: DataKind>(count: usize, most: usize) -> Subjects<K> {
    let mut subjects = Subjects::new(most);
    queries(count)
        .into_iter()
        .for_each(|query| subjects.add(Subject::new(query, None)));
    subjects
}

#[test]
fn every_cell_of_every_method_is_filled() {
    let mut comparison = comparison(exact_ccd_methods::all(), Duration::from_secs(1));
    let table = comparison.run("random", &subjects::<EdgeEdge>(100, 40), &|_| ());
    assert_eq!(table.rows.len(), exact_ccd_methods::all().len());
    for (row, method) in table.rows.iter().zip(exact_ccd_methods::all()) {
        let times = [
            row.mean,
            row.mean_colliding,
            row.mean_free,
            row.median,
            row.percentile_99,
            row.worst,
        ];
        assert!(
            times.iter().all(|time| time.is_some_and(|time| time >= 0.0)),
            "{row:?}"
        );
        assert_eq!(
            row.time_error.is_some(),
            method.guarantees().time != TimeGuarantee::Absent,
            "{row:?}"
        );
    }
}

#[test]
fn answers_are_judged_by_the_truth() {
    let mut comparison = comparison(vec![Box::new(Exact), Box::new(Liar)], Duration::from_secs(100));
    let subjects = subjects::<VertexFace>(1000, 1000);
    let [free, colliding] = subjects.population();
    assert!(free + colliding == 1000 && colliding > 30, "{colliding}");
    let table = comparison.run("random", &subjects, &|_| ());
    let [exact, liar] = &table.rows[..] else {
        panic!("{table:?}")
    };
    assert_eq!([exact.false_positives, exact.false_negatives], [0, 0]);
    assert_eq!(exact.time_error.unwrap().worst, 0.0);
    assert_eq!([liar.false_positives, liar.false_negatives], [free, colliding]);
    // False positives have no time error, because there is no true time.
    assert_eq!(liar.time_error, None);
}

/// The sample has as many queries of the rare class as of the other, and means weight both by their shares.
#[test]
fn a_sample_has_half_of_its_queries_in_contact() {
    let subjects = subjects::<VertexFace>(2000, 20);
    let sample = subjects.sample();
    assert_eq!(sample.len(), 40);
    assert_eq!(sample.iter().filter(|subject| subject.collides).count(), 20);
    let table = comparison(vec![Box::new(Exact)], Duration::from_secs(100)).run("random", &subjects, &|_| ());
    let row = &table.rows[0];
    let (tp, tn) = (row.mean_colliding.unwrap(), row.mean_free.unwrap());
    let expected = (tp * table.colliding as f64 + tn * (table.queries - table.colliding) as f64) / 2000.0;
    assert!((row.mean.unwrap() - expected).abs() <= 1e-9 * expected);
}

/// Sleeps.
struct Slow;

impl<K: Kind> Decide<K> for Slow {
    fn collides(&self, query: &Query<K>) -> bool {
        self.time_of_impact(query).is_some()
    }

    fn time_of_impact(&self, query: &Query<K>) -> Option<f64> {
        std::thread::sleep(Duration::from_millis(100));
        query.time_of_impact(CONTACT)
    }
}

impl Ccd for Slow {
    fn name(&self) -> &'static str {
        "slow"
    }

    fn guarantees(&self) -> Guarantees {
        Exact.guarantees()
    }
}

#[test]
fn a_method_without_budget_stops_and_the_others_continue() {
    let mut comparison = comparison(vec![Box::new(Slow), Box::new(Exact)], Duration::from_secs(1));
    let table = comparison.run("random", &subjects::<EdgeEdge>(2000, 200), &|_| ());
    let [slow, exact] = &table.rows[..] else {
        panic!("{table:?}")
    };
    // A method that answers only a few queries answers both classes.
    let seen = slow.answered.colliding + slow.answered.free;
    assert!((1..=20).contains(&seen), "{:?}", slow.answered);
    assert!(
        slow.answered.colliding.abs_diff(slow.answered.free) <= 1,
        "{:?}",
        slow.answered
    );
    assert!(exact.answered.free > slow.answered.free, "{exact:?}");
    assert!(table.markdown().contains(&format!(
        "| slow | {} + {} |",
        slow.answered.colliding, slow.answered.free
    )));
}

fn write_queries<K: DataKind>(folder: &Path, truth: bool) {
    let folder = folder.join(K::FOLDER);
    fs::create_dir_all(&folder).unwrap();
    let mut writer = QueryWriter::new(Vec::new(), Seventh::Contact);
    for query in queries::<K>(50) {
        let truth = truth.then(|| query.collides(CONTACT));
        writer.write(&Record::from(Sample { query, truth })).unwrap();
    }
    fs::write(folder.join("random.csv"), writer.into_inner()).unwrap();
}

fn run_all(folder: &Path) -> Vec<Table> {
    let mut comparison = comparison(vec![Box::new(Exact)], Duration::from_secs(10));
    let mut tables = Vec::new();
    for source in Source::all(folder).unwrap() {
        let vertex_face = source.read::<VertexFace>(1000).unwrap();
        tables.push(comparison.run(source.name(), &vertex_face, &|_| ()));
        let edge_edge = source.read::<EdgeEdge>(1000).unwrap();
        tables.push(comparison.run(source.name(), &edge_edge, &|_| ()));
    }
    tables
}

/// Query folders side by side are one data set as they are and one rounded, at any depth in the
/// folder.
#[test]
fn query_files_are_found_as_the_published_sets_lie() {
    let folder = tempfile::tempdir().unwrap();
    for scene in ["spike", "wedge"] {
        write_queries::<VertexFace>(&folder.path().join("published").join(scene), true);
        write_queries::<EdgeEdge>(&folder.path().join("published").join(scene), false);
    }
    let names = |start: &Path| -> Vec<String> {
        let sources = Source::all(start).unwrap();
        sources.iter().map(|source| source.name().to_owned()).collect()
    };
    assert_eq!(
        names(&folder.path().join("published/spike")),
        ["spike", "spike, rounded"]
    );
    for start in [folder.path().to_owned(), folder.path().join("published")] {
        let tables = run_all(&start);
        let names: Vec<_> = tables
            .iter()
            .map(|table| (table.data_set.as_str(), table.kind))
            .collect();
        let (plain, rounded) = ("published", "published, rounded");
        assert_eq!(
            names,
            [(plain, "vf"), (plain, "ee"), (rounded, "vf"), (rounded, "ee")]
        );
        for table in &tables {
            assert_eq!(table.queries, 100);
            assert_eq!(
                [table.rows[0].false_positives, table.rows[0].false_negatives],
                [0, 0]
            );
        }
    }
    assert_eq!(
        Source::all(&folder.path().join("published/spike/vertex-face")).unwrap(),
        []
    );
}

#[test]
fn a_report_is_replaced_as_it_grows() {
    let folder = tempfile::tempdir().unwrap();
    let mut report = Report::new(&[]);
    for name in ["first", "second, rounded"] {
        let table = comparison(exact_ccd_methods::all(), Duration::from_millis(100)).run(
            name,
            &subjects::<VertexFace>(60, 20),
            &|_| (),
        );
        report.tables.push(table);
        report.write(folder.path()).unwrap();
        let markdown = fs::read_to_string(folder.path().join("report.md")).unwrap();
        let csv = fs::read_to_string(folder.path().join("report.csv")).unwrap();
        let json = fs::read_to_string(folder.path().join("report.json")).unwrap();
        assert_eq!(markdown.matches("### ").count(), report.tables.len());
        assert_eq!(csv.lines().count(), 1 + 11 * report.tables.len());
        let json: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert_eq!(json["tables"].as_array().unwrap().len(), report.tables.len());
    }
    let mut reader = csv::Reader::from_path(folder.path().join("report.csv")).unwrap();
    for record in reader.records() {
        assert_eq!(record.unwrap().len(), 18);
    }
    let files: Vec<_> = fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    assert_eq!(files.len(), 3 + 4, "{files:?}");
    for name in [
        "tails-first-vf",
        "accuracy-first-vf",
        "tails-second-rounded-vf",
        "accuracy-second-rounded-vf",
    ] {
        let drawing = fs::read_to_string(folder.path().join(format!("{name}.svg"))).unwrap();
        assert!(drawing.contains("FPRF"), "{name}");
    }
}
