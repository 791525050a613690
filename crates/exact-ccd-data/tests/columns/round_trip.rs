//! Lossless round trips of records and of rows.

use exact_ccd::{EdgeEdge, Point, VertexFace};
use exact_ccd_data::{ColumnWriter, DataKind, QueryReader, QueryWriter, Record, Rounding, Seventh};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use crate::{Reader, Rest, bits, full, record, written};

#[track_caller]
fn assert_survive<K: DataKind>(records: &[Record<K>]) {
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
        let records = || records.iter().cloned();
        assert_survive(&records().map(|(points, rest)| record::<VertexFace>(points, rest)).collect::<Vec<_>>());
        assert_survive(&records().map(|(points, rest)| record::<EdgeEdge>(points, rest)).collect::<Vec<_>>());
    }

    #[test]
    fn rows_come_back_byte_for_byte(queries in prop::collection::vec((points(), any::<bool>(), -1i64..5), 0..20)) {
        for seventh in [None, Some(Seventh::Contact), Some(Seventh::Count)] {
            let mut rows = QueryWriter::new(Vec::new(), seventh.unwrap_or_default());
            for &(points, truth, count) in &queries {
                let truth = seventh.map(|_| truth);
                let rest = (truth, (seventh == Some(Seventh::Count)).then_some(count), None, None, None);
                rows.write(&record::<EdgeEdge>(points, rest)).unwrap();
            }
            let text = rows.into_inner();
            let reader = QueryReader::<EdgeEdge, _>::new("rows", text.as_slice(), Rounding::Refuse)
                .with_seventh(seventh.unwrap_or_default());
            let records: Vec<_> = reader.records().collect::<Result<_, _>>().unwrap();
            let mut again = QueryWriter::new(Vec::new(), seventh.unwrap_or_default());
            for record in Reader::new().read::<EdgeEdge>(&written(&records)).unwrap() {
                again.write(&record).unwrap();
            }
            prop_assert_eq!(again.into_inner(), text);
        }
    }
}

#[test]
fn files_of_many_row_groups_survive() {
    let records: Vec<_> = (0..140_000).map(full).collect();
    assert_survive(&records);
    assert_survive(&records[..1 << 16]);
    assert_survive::<VertexFace>(&[]);
}

#[test]
fn ids_that_do_not_fit_are_an_error() {
    let ids = Some([0, 1 << 63]);
    let error = ColumnWriter::new(Vec::new())
        .unwrap()
        .write(Record { ids, ..full(0) })
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "the id 9223372036854775808 is out of the range of int64"
    );
}
