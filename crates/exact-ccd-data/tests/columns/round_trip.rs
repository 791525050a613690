//! Lossless round trips of records and of rows.

use exact_ccd::{EdgeEdge, Kind, Point, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_data::{ColumnWriter, QueryReader, QueryWriter, Record, Rounding, Seventh};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use crate::{Reader, Rest, bits, full, record, written};

#[track_caller]
fn assert_survive<K: Kind>(records: &[Record<K>]) {
    let read = Reader::new().read::<K>(&written(records)).unwrap();
    assert!(
        read.iter().map(bits).eq(records.iter().map(bits)),
        "{} and {} records",
        read.len(),
        records.len()
    );
}

fn points() -> impl Strategy<Value = [[Point; 4]; 2]> {
    let finite = prop::num::f64::ANY.prop_map(|x| if x.is_finite() { x } else { -0.0 });
    let coordinate = prop_oneof![finite, Just(0.0), Just(-0.0)];
    prop::array::uniform2(prop::array::uniform4(prop::array::uniform3(coordinate)))
}

fn rest() -> impl Strategy<Value = Rest> {
    let id = 0..=i64::MAX as u64;
    (
        any::<Option<bool>>(),
        prop::option::of(-1..=i64::MAX),
        prop::option::of(prop_oneof![0.0..=1.0, Just(-0.0), Just(5e-324)]),
        any::<Option<String>>(),
        prop::option::of([id.clone(), id]),
    )
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: RngSeed::Fixed(0),
        failure_persistence: None,
        ..ProptestConfig::with_cases(64)
    })]

    #[test]
    fn every_record_survives(records in prop::collection::vec((points(), rest()), 0..20)) {
        fn check<K: Kind>(records: &[([[Point; 4]; 2], Rest)]) {
            let records = records.iter().cloned();
            assert_survive(&records.map(|(points, rest)| record::<K>(points, rest)).collect::<Vec<_>>());
        }
        check::<VertexFace>(&records);
        check::<EdgeEdge>(&records);
        check::<VertexEdge>(&records);
        check::<VertexVertex>(&records);
    }

    #[test]
    fn rows_come_back_byte_for_byte(queries in prop::collection::vec((points(), any::<bool>(), -1i64..5), 0..20)) {
        for seventh in [None, Some(Seventh::Contact), Some(Seventh::Count)] {
            assert_rows_come_back::<EdgeEdge>(&queries, seventh);
            assert_rows_come_back::<VertexEdge>(&queries, seventh);
            assert_rows_come_back::<VertexVertex>(&queries, seventh);
        }
    }
}

/// Queries with their truth and count. The file has the seventh column only.
fn assert_rows_come_back<K: Kind>(queries: &[([[Point; 4]; 2], bool, i64)], seventh: Option<Seventh>) {
    let meaning = seventh.unwrap_or_default();
    let mut rows = QueryWriter::new(Vec::new(), meaning);
    for &(points, truth, count) in queries {
        let truth = seventh.map(|_| truth);
        let count = (seventh == Some(Seventh::Count)).then_some(count);
        let record = record::<K>(points, (truth, count, None, None, None));
        rows.write(&record).unwrap();
    }
    let text = rows.into_inner();
    let lines = text.iter().filter(|&&byte| byte == b'\n').count();
    assert_eq!(lines, queries.len() * 2 * K::KIND.point_names().len());
    let reader = QueryReader::<K, _>::new("rows", text.as_slice(), Rounding::Refuse).with_seventh(meaning);
    let records: Vec<_> = reader.collect::<Result<_, _>>().unwrap();
    let mut again = QueryWriter::new(Vec::new(), meaning);
    for record in Reader::new().read::<K>(&written(&records)).unwrap() {
        again.write(&record).unwrap();
    }
    assert_eq!(again.into_inner(), text);
}

#[test]
fn files_of_many_row_groups_survive() {
    let records: Vec<_> = (0..140_000).map(full).collect();
    assert_survive(&records);
    assert_survive(&records[..1 << 16]);
    assert_survive::<VertexFace>(&[]);
}

/// Values that a reader refuses are not written.
#[test]
fn values_out_of_range_are_an_error() {
    let error = |record| {
        let writer = ColumnWriter::<VertexFace, _>::new(Vec::new());
        writer.unwrap().write(record).unwrap_err().to_string()
    };
    let ids = Some([0, 1 << 63]);
    assert_eq!(
        error(Record { ids, ..full(0) }),
        "the id 9223372036854775808 is out of the range of int64"
    );
    let count = Some(-2);
    assert_eq!(
        error(Record { count, ..full(0) }),
        "expected a number of contacts or -1 as count, found -2"
    );
    let mut rows = QueryWriter::new(Vec::new(), Seventh::Count);
    let refused = rows.write::<VertexFace>(&Record { count, ..full(0) });
    assert_eq!(
        refused.unwrap_err().to_string(),
        "query 0 has -2 as number of contacts"
    );
    for (toi, found) in [(-0.5, "-0.5"), (1.5, "1.5"), (f64::NAN, "NaN")] {
        let toi = Some(toi);
        assert_eq!(
            error(Record { toi, ..full(0) }),
            format!("expected a time from 0 to 1 as toi, found {found}")
        );
    }
}
