//! Times within a distance against truth from rational arithmetic.
//!
//! `KIND-FAMILY-dD.csv` holds the queries, with the decision for the distance D; `….times.csv` the
//! times within D.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use dashu_ratio::RBig;
use exact_ccd::separation::{Separation, TimeInterval};
use exact_ccd::{EdgeEdge, Kind, Point, Query, VertexEdge, VertexFace, VertexVertex, exact};

use crate::data;

/// A query, and the decision.
struct Sample<K> {
    query: Query<K>,
    comes_within: bool,
}

/// The times of a query within a distance.
struct Times {
    count: usize,
    first: f64,
    first_is_exact: bool,
    /// The ends of the intervals, rounded down.
    intervals: Vec<[f64; 2]>,
}

/// The fields of all rows of a file.
fn rows(file: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(file).unwrap();
    let fields = |line: &str| line.split(',').map(str::to_owned).collect();
    text.lines().map(fields).collect()
}

fn samples<K: Kind, const N: usize>(file: &Path) -> Vec<Sample<K>>
where
    [Point; N]: Into<K::Points>,
{
    let point = |row: &[String]| {
        [0, 2, 4].map(|i: usize| {
            let fraction: RBig = format!("{}/{}", row[i], row[i + 1]).parse().unwrap();
            let (value, is_exact) = fraction.to_f64().value_with_exact();
            assert!(is_exact, "{}: {fraction} is no f64", file.display());
            value
        })
    };
    let rows = rows(file);
    assert_eq!(rows.len() % (2 * N), 0, "{}", file.display());
    let at = |rows: &[Vec<String>]| -> [Point; N] { std::array::from_fn(|i| point(&rows[i])) };
    rows.chunks_exact(2 * N)
        .map(|rows| Sample {
            query: Query::new(at(&rows[..N]).into(), at(&rows[N..]).into()).unwrap(),
            comes_within: rows[0][6] == "1",
        })
        .collect()
}

fn times(file: &Path) -> BTreeMap<usize, Times> {
    let time = |text: &str| text.parse::<f64>().unwrap();
    let parse = |row: &Vec<String>| {
        let interval = |text: &str| {
            let (start, end) = text.split_once(':').unwrap();
            [time(start), time(end)]
        };
        let times = Times {
            count: row[1].parse().unwrap(),
            first: time(&row[2]),
            first_is_exact: row[3] == "1",
            intervals: row[4].split(' ').map(interval).collect(),
        };
        (row[0].parse().unwrap(), times)
    };
    rows(file)[1..].iter().map(parse).collect()
}

/// The paths of the query files of a kind, and the distances in their names.
fn files(kind: &str) -> Vec<(PathBuf, Separation)> {
    let distance = |file: &Path| {
        let name = file.file_name()?.to_str()?;
        let (family, d) = name.strip_suffix(".csv")?.rsplit_once("-d")?;
        let d: f64 = d.parse().ok()?;
        family.starts_with(kind).then(|| Separation::new(d).unwrap())
    };
    let with_distance = |file: PathBuf| distance(&file).map(|d| (file, d));
    data()
        .separation()
        .unwrap()
        .into_iter()
        .filter_map(with_distance)
        .collect()
}

fn assert_same(intervals: &[TimeInterval], truth: &Times, place: &str) {
    let lower: Vec<[f64; 2]> = intervals
        .iter()
        .map(|i| [i.start.lower(), i.end.lower()])
        .collect();
    assert_eq!(lower.len(), truth.count, "{place}");
    assert_eq!(lower, truth.intervals, "{place}");
    assert_eq!(lower[0][0].to_bits(), truth.first.to_bits(), "{place}");
    assert_eq!(intervals[0].start.is_exact(), truth.first_is_exact, "{place}");
}

fn check<K: Kind, const N: usize>(kind: &str, expected: usize)
where
    [Point; N]: Into<K::Points>,
{
    let mut count = 0;
    for (file, d) in files(kind) {
        let truth = times(&file.with_extension("times.csv"));
        for (index, Sample { query, comes_within }) in samples::<K, N>(&file).into_iter().enumerate() {
            let place = format!("query {index} of {}", file.display());
            assert_eq!(truth.contains_key(&index), comes_within, "{place}");
            assert_eq!(query.comes_within(d), comes_within, "{place}");
            assert_eq!(
                exact::separation::comes_within(&query, d),
                comes_within,
                "exactly, {place}"
            );
            let (fast, exact) = (query.first_within(d), exact::separation::first_within(&query, d));
            let intervals = query.intervals_within(d);
            let exact_intervals = exact::separation::intervals_within(&query, d);
            match truth.get(&index) {
                Some(truth) => {
                    assert_same(&intervals, truth, &place);
                    assert_same(&exact_intervals, truth, &format!("exactly, {place}"));
                    for first in [fast, exact] {
                        let first = first.map(|time| (time.lower().to_bits(), time.is_exact()));
                        assert_eq!(
                            first,
                            Some((truth.first.to_bits(), truth.first_is_exact)),
                            "{place}"
                        );
                    }
                }
                None => {
                    assert_eq!((fast, exact), (None, None), "{place}");
                    assert!(intervals.is_empty() && exact_intervals.is_empty(), "{place}");
                }
            }
            count += 1;
        }
    }
    assert_eq!(count, expected);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn vertex_face_queries_within_a_distance_agree() {
    check::<VertexFace, 4>("vf", 1172);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn edge_edge_queries_within_a_distance_agree() {
    check::<EdgeEdge, 4>("ee", 1240);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn vertex_edge_queries_within_a_distance_agree() {
    check::<VertexEdge, 3>("ve", 1240);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn vertex_vertex_queries_within_a_distance_agree() {
    check::<VertexVertex, 2>("vv", 1240);
}
