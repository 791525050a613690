//! Times within a distance against truth from rational arithmetic, by the fast path and by the exact one.

use std::collections::BTreeMap;

use exact_ccd::{EdgeEdge, Intervals, Kind, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_data::{QueryReader, Rounding, Sample, TimesWithin};

use crate::data;

fn assert_same(intervals: &Intervals, truth: &TimesWithin, place: &str) {
    let lower: Vec<[f64; 2]> = intervals
        .iter()
        .map(|i| [i.start.lower(), i.end.lower()])
        .collect();
    assert_eq!(lower.len(), truth.count, "{place}");
    assert_eq!(lower, truth.intervals, "{place}");
    assert_eq!(lower[0][0].to_bits(), truth.toi.to_bits(), "{place}");
    assert_eq!(intervals[0].start.is_exact(), truth.toi_is_exact, "{place}");
}

fn check<K: Kind>(expected: usize) {
    let mut count = 0;
    for file in data().separation::<K>().unwrap() {
        let d = file.d;
        let truth: BTreeMap<usize, TimesWithin> = file
            .times()
            .unwrap()
            .into_iter()
            .map(|times| (times.query, times))
            .collect();
        let records = QueryReader::<K, _>::open(&file.queries, Rounding::Refuse).unwrap();
        for (index, record) in records.enumerate() {
            let Sample { query, truth: within } = record.unwrap().sample;
            let comes_within = within.unwrap();
            let place = format!("query {index} of {}", file.queries.display());
            assert_eq!(truth.contains_key(&index), comes_within, "{place}");
            let decisions = [query.collides(d), query.exactly().collides(d)];
            assert_eq!(decisions, [comes_within; 2], "{place}");
            let first = query.collision(d).map(|collision| collision.time());
            let lower = query.exactly().time_of_impact(d);
            let intervals = query.intervals(d);
            let exact_intervals = query.exactly().intervals(d);
            match truth.get(&index) {
                Some(truth) => {
                    assert_same(&intervals, truth, &place);
                    assert_same(&exact_intervals, truth, &format!("exactly, {place}"));
                    let first = first.map(|time| (time.lower().to_bits(), time.is_exact()));
                    assert_eq!(first, Some((truth.toi.to_bits(), truth.toi_is_exact)), "{place}");
                    assert_eq!(lower.map(f64::to_bits), Some(truth.toi.to_bits()), "{place}");
                }
                None => {
                    assert_eq!((first, lower), (None, None), "{place}");
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
    check::<VertexFace>(1172);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn edge_edge_queries_within_a_distance_agree() {
    check::<EdgeEdge>(1240);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn vertex_edge_queries_within_a_distance_agree() {
    check::<VertexEdge>(1240);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn vertex_vertex_queries_within_a_distance_agree() {
    check::<VertexVertex>(1240);
}
