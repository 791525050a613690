//! Parquet files: lossless round trips, files of other software, and the errors of damaged ones.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

use exact_ccd::{EdgeEdge, Point, Query, VertexFace};
use exact_ccd_data::{
    ColumnReader, ColumnWriter, DataError, DataKind, QueryReader, QueryWriter, Record, Rounding, Sample,
    Seventh,
};
use parquet::basic::Compression;
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use tempfile::TempDir;

fn written<K: DataKind>(records: &[Record<K>]) -> Vec<u8> {
    let mut writer = ColumnWriter::new(Vec::new()).unwrap();
    records
        .iter()
        .for_each(|record| writer.write(record.clone()).unwrap());
    writer.finish().unwrap()
}

/// A folder to read files in.
struct Reader(TempDir);

impl Reader {
    fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    fn file(&self) -> PathBuf {
        self.0.path().join("q.parquet")
    }

    fn read<K: DataKind>(&self, bytes: &[u8]) -> Result<Vec<Record<K>>, DataError> {
        fs::write(self.file(), bytes).unwrap();
        ColumnReader::open(&self.file())?.records().collect()
    }

    /// The error, without the name of the file at its beginning.
    #[track_caller]
    fn error<K: DataKind>(&self, bytes: &[u8]) -> String {
        let error = self.read::<K>(bytes).err().unwrap().to_string();
        error
            .strip_prefix(self.file().to_str().unwrap())
            .unwrap()
            .to_owned()
    }
}

/// The fields of a record, each f64 as its bits.
fn bits<K: DataKind>(record: &Record<K>) -> impl PartialEq + std::fmt::Debug + use<K> {
    let Record {
        sample,
        count,
        toi,
        scene,
        ids,
    } = record.clone();
    let points = sample
        .query
        .points()
        .map(|points| points.map(|point| point.map(f64::to_bits)));
    (points, sample.truth, count, toi.map(f64::to_bits), scene, ids)
}

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

type Rest = (
    Option<bool>,
    Option<i64>,
    Option<f64>,
    Option<String>,
    Option<[u64; 2]>,
);

fn record<K: DataKind>(points: [[Point; 4]; 2], (truth, count, toi, scene, ids): Rest) -> Record<K> {
    let query = Query::new(points[0], points[1]).unwrap();
    Record {
        sample: Sample { query, truth },
        count,
        toi,
        scene: scene.map(Arc::from),
        ids,
    }
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

/// A record with all fields, which depend on the number.
fn full(number: u32) -> Record<VertexFace> {
    let mut points = [[[0.0; 3]; 4]; 2];
    for (index, x) in points
        .as_flattened_mut()
        .as_flattened_mut()
        .iter_mut()
        .enumerate()
    {
        *x = f64::from(number) + index as f64 / 8.0;
    }
    let ids = [number.into(), u64::from(number) + 7];
    record(
        points,
        (
            Some(number.is_multiple_of(2)),
            Some(number.into()),
            Some(0.5),
            Some("fall".into()),
            Some(ids),
        ),
    )
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

#[test]
fn files_cut_short_are_an_error() {
    let (reader, bytes) = (Reader::new(), written(&[full(0), full(1), full(2)]));
    for length in 0..bytes.len() {
        let error = reader.error::<VertexFace>(&bytes[..length]);
        assert!(
            error.starts_with(": expected a Parquet file of queries: "),
            "{length}: {error}"
        );
    }
}

/// A wrong byte is an error or changes no query: the queries have checksums.
#[test]
fn damage_is_an_error_or_does_not_matter() {
    let records = [full(0), full(1), full(2)];
    let (reader, sound) = (Reader::new(), written(&records));
    let mut errors = 0;
    for index in 0..sound.len() {
        for mask in [0x01, 0x10, 0x80, 0xff] {
            let mut bytes = sound.clone();
            bytes[index] ^= mask;
            match reader.read::<VertexFace>(&bytes) {
                Ok(read) => assert!(
                    read.iter().map(bits).eq(records.iter().map(bits)),
                    "{index}, {mask:#x}"
                ),
                Err(_) => errors += 1,
            }
        }
    }
    assert!(errors > 2 * sound.len(), "{errors}");
}

/// A page of another writer, or of a forger, says that it has 2³⁰ bytes.
#[test]
fn pages_that_are_too_large_are_refused() {
    let mut bytes = written(&[full(0)]);
    // The first page: its type is dictionary, and its size is a number of one byte, which five
    // bytes now stand for.
    assert_eq!(bytes[4..8], [0x15, 0x04, 0x15, bytes[7] & 0x7f]);
    bytes.splice(7..8, [0x80, 0x80, 0x80, 0x80, 0x08]);
    let error = Reader::new().error::<VertexFace>(&bytes);
    assert_eq!(
        error,
        ": expected a Parquet file of queries: a page of 1073741824 bytes"
    );
}

/// The columns of a query as other software writes them: all of them nullable, in another order,
/// with one more.
const FOREIGN: &str = "message schema {
    optional int64 more;
    optional int64 id_b;
    optional int64 id_a;
    optional binary scene (STRING);
    optional double toi;
    optional int64 count;
    optional boolean truth;
    optional group points (LIST) { repeated group bag { optional double array; } }
    optional binary kind (STRING);
}";

/// A row in these columns.
struct Foreign {
    ids: [Option<i64>; 2],
    scene: &'static [u8],
    toi: f64,
    count: i64,
    points: Vec<Option<f64>>,
    kind: Option<&'static str>,
}

impl Default for Foreign {
    fn default() -> Self {
        Self {
            ids: [Some(3), Some(4)],
            scene: b"fall",
            toi: 0.5,
            count: -1,
            points: (0..24).map(|x| Some(f64::from(x))).collect(),
            kind: Some("vf"),
        }
    }
}

impl Foreign {
    fn written(&self, schema: &str) -> Vec<u8> {
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .build();
        let schema = Arc::new(parse_message_type(schema).unwrap());
        let fields = schema.get_fields().to_vec();
        let mut file = SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties)).unwrap();
        let mut group = file.next_row_group().unwrap();
        for field in fields {
            let mut column = group.next_column().unwrap().unwrap();
            let int64 = |value: Option<i64>| (Vec::from_iter(value), [i16::from(value.is_some())]);
            match field.name() {
                name @ ("id_a" | "id_b" | "count" | "more") => {
                    let (values, level) = int64(match name {
                        "id_a" => self.ids[0],
                        "id_b" => self.ids[1],
                        "count" => Some(self.count),
                        _ => None,
                    });
                    column
                        .typed::<Int64Type>()
                        .write_batch(&values, Some(&level), None)
                }
                "scene" => {
                    let scene = ByteArray::from(self.scene);
                    column
                        .typed::<ByteArrayType>()
                        .write_batch(&[scene], Some(&[1]), None)
                }
                "kind" => {
                    let kinds: Vec<_> = self.kind.iter().map(|&kind| ByteArray::from(kind)).collect();
                    let level = [kinds.len() as i16];
                    column
                        .typed::<ByteArrayType>()
                        .write_batch(&kinds, Some(&level), None)
                }
                "toi" => column
                    .typed::<DoubleType>()
                    .write_batch(&[self.toi], Some(&[1]), None),
                "truth" => column.typed::<BoolType>().write_batch(&[true], Some(&[1]), None),
                _ => {
                    let values: Vec<_> = self.points.iter().flatten().copied().collect();
                    let definition: Vec<_> = self.points.iter().map(|x| 2 + i16::from(x.is_some())).collect();
                    let repetition: Vec<_> = (0..self.points.len()).map(|index| (index > 0).into()).collect();
                    let points = column.typed::<DoubleType>();
                    points.write_batch(&values, Some(&definition), Some(&repetition))
                }
            }
            .unwrap();
            column.close().unwrap();
        }
        group.close().unwrap();
        file.into_inner().unwrap()
    }

    #[track_caller]
    fn assert_error(&self, expected: &str) {
        let error = Reader::new().error::<VertexFace>(&self.written(FOREIGN));
        assert_eq!(error, format!(", query 0: {expected}"));
    }
}

#[test]
fn other_software_can_write_the_columns() {
    let records = Reader::new()
        .read::<VertexFace>(&Foreign::default().written(FOREIGN))
        .unwrap();
    let coordinates: Vec<_> = records[0]
        .sample
        .query
        .points()
        .as_flattened()
        .as_flattened()
        .to_vec();
    assert_eq!(coordinates, (0..24).map(f64::from).collect::<Vec<_>>());
    let points = *records[0].sample.query.points();
    let rest = (
        Some(true),
        Some(-1),
        Some(0.5),
        Some("fall".to_owned()),
        Some([3, 4]),
    );
    assert_eq!(records, [record(points, rest)]);
}

#[test]
fn values_that_cannot_be_are_an_error() {
    let sound = Foreign::default;
    let list = "expected 24 coordinates as points, found null or another number";
    let with = |index: usize, value| {
        let mut points = sound().points;
        points[index] = value;
        Foreign { points, ..sound() }
    };
    Foreign {
        kind: None,
        ..sound()
    }
    .assert_error("expected vf as kind, found null");
    Foreign {
        kind: Some("ee"),
        ..sound()
    }
    .assert_error("expected vf as kind, found ee");
    Foreign {
        kind: Some("v\nf"),
        ..sound()
    }
    .assert_error("expected vf as kind, found v\\nf");
    Foreign {
        points: vec![Some(0.0); 23],
        ..sound()
    }
    .assert_error(list);
    Foreign {
        points: vec![Some(0.0); 25],
        ..sound()
    }
    .assert_error(list);
    with(5, None).assert_error(list);
    with(23, Some(f64::INFINITY))
        .assert_error("coordinate z of point 3 at t = 1 is inf, not a finite number");
    with(0, Some(f64::NAN)).assert_error("coordinate x of point 0 at t = 0 is NaN, not a finite number");
    Foreign { count: -2, ..sound() }.assert_error("expected a number of contacts or -1 as count, found -2");
    Foreign { toi: 1.5, ..sound() }.assert_error("expected a time from 0 to 1 as toi, found 1.5");
    Foreign {
        toi: f64::NAN,
        ..sound()
    }
    .assert_error("expected a time from 0 to 1 as toi, found NaN");
    Foreign {
        scene: b"\xff",
        ..sound()
    }
    .assert_error("expected UTF-8 as scene, found \u{fffd}");
    let ids = "expected two ids of 0 or more, or none as id_a and id_b, found";
    Foreign {
        ids: [Some(1), None],
        ..sound()
    }
    .assert_error(&format!("{ids} 1 and null"));
    Foreign {
        ids: [Some(1), Some(-1)],
        ..sound()
    }
    .assert_error(&format!("{ids} 1 and -1"));
}

#[test]
fn other_columns_are_an_error() {
    for (from, to, expected) in [
        (
            "optional boolean truth;",
            "",
            "column truth should have BOOLEAN, found none",
        ),
        (
            "int64 count",
            "double count",
            "column count should have INT64, found DOUBLE",
        ),
        (
            "double toi",
            "int32 toi",
            "column toi should have DOUBLE, found INT32",
        ),
        (
            "optional binary scene",
            "repeated binary scene",
            "column scene should have strings, found lists of BYTE_ARRAY",
        ),
        (
            "optional double array;",
            "optional double array; optional double other;",
            "column points should have lists of 24 DOUBLE, found a group of columns",
        ),
        (
            "{ repeated group bag { optional double array; } }",
            "{ repeated group bag { optional float array; } }",
            "column points should have lists of 24 DOUBLE, found lists of FLOAT",
        ),
    ] {
        let schema = FOREIGN.replace(from, to);
        assert_ne!(schema, FOREIGN);
        let schema = Arc::new(parse_message_type(&schema).unwrap());
        let file = SerializedFileWriter::new(Vec::new(), schema, Arc::default()).unwrap();
        let error = Reader::new().error::<VertexFace>(&file.into_inner().unwrap());
        assert_eq!(error, format!(": expected a Parquet file of queries: {expected}"));
    }
}

#[test]
fn other_files_are_an_error() {
    let reader = Reader::new();
    for bytes in [
        &b""[..],
        b"PAR1",
        b"PAR1PAR1",
        b"0,1,0,1,0,1\n",
        &[0; 1000],
        &[0xff; 1000],
    ] {
        let error = reader.error::<VertexFace>(bytes);
        assert!(
            error.starts_with(": expected a Parquet file of queries: "),
            "{error}"
        );
    }
    let missing = ColumnReader::<VertexFace>::open(&reader.0.path().join("missing"))
        .err()
        .unwrap();
    assert!(matches!(missing, DataError::Io { .. }));
    let folder = ColumnReader::<VertexFace>::open(reader.0.path()).err().unwrap();
    assert!(folder.to_string().contains("irectory"), "{folder}");
}
