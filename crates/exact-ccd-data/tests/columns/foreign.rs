//! Parquet files of other software.

use std::sync::Arc;

use exact_ccd::VertexFace;
use exact_ccd_data::ColumnReader;
use parquet::basic::Compression;
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;

use crate::{Reader, record};

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
        Self::all_written(&[self], schema)
    }

    fn all_written(rows: &[&Self], schema: &str) -> Vec<u8> {
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_write_page_header_statistics(true)
            .set_statistics_truncate_length(None)
            .build();
        let schema = Arc::new(parse_message_type(schema).unwrap());
        let fields = schema.get_fields().to_vec();
        let mut file = SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties)).unwrap();
        let mut group = file.next_row_group().unwrap();
        for field in fields {
            let mut column = group.next_column().unwrap().unwrap();
            let int64 = |value: Option<i64>| (Vec::from_iter(value), [i16::from(value.is_some())]);
            for row in rows {
                match field.name() {
                    name @ ("id_a" | "id_b" | "count" | "more") => {
                        let (values, level) = int64(match name {
                            "id_a" => row.ids[0],
                            "id_b" => row.ids[1],
                            "count" => Some(row.count),
                            _ => None,
                        });
                        column
                            .typed::<Int64Type>()
                            .write_batch(&values, Some(&level), None)
                    }
                    "scene" => {
                        let scene = ByteArray::from(row.scene);
                        column
                            .typed::<ByteArrayType>()
                            .write_batch(&[scene], Some(&[1]), None)
                    }
                    "kind" => {
                        let kinds: Vec<_> = row.kind.iter().map(|&kind| ByteArray::from(kind)).collect();
                        let level = [kinds.len() as i16];
                        column
                            .typed::<ByteArrayType>()
                            .write_batch(&kinds, Some(&level), None)
                    }
                    "toi" => column
                        .typed::<DoubleType>()
                        .write_batch(&[row.toi], Some(&[1]), None),
                    "truth" => column.typed::<BoolType>().write_batch(&[true], Some(&[1]), None),
                    _ => {
                        let values: Vec<_> = row.points.iter().flatten().copied().collect();
                        let definition: Vec<_> =
                            row.points.iter().map(|x| 2 + i16::from(x.is_some())).collect();
                        let repetition: Vec<_> =
                            (0..row.points.len()).map(|index| (index > 0).into()).collect();
                        let points = column.typed::<DoubleType>();
                        points.write_batch(&values, Some(&definition), Some(&repetition))
                    }
                }
                .unwrap();
            }
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

/// Other software can write the least and the greatest value into the header of a page.
#[test]
fn headers_of_pages_can_be_long() {
    let foreign = Foreign {
        scene: &[b'a'; 100_000],
        ..Foreign::default()
    };
    let bytes = foreign.written(FOREIGN);
    assert!(bytes.len() > 200_000);
    let records = Reader::new().read::<VertexFace>(&bytes).unwrap();
    assert_eq!(records[0].scene.as_deref().map(str::len), Some(100_000));
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
            "column points should have lists of DOUBLE, found a group of columns",
        ),
        (
            "{ repeated group bag { optional double array; } }",
            "{ repeated group bag { optional float array; } }",
            "column points should have lists of DOUBLE, found lists of FLOAT",
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

/// The rows before a wrong one are read, as from a text file.
#[test]
fn queries_before_a_wrong_one_are_read() {
    let (right, wrong) = (
        Foreign::default(),
        Foreign {
            toi: 2.0,
            ..Foreign::default()
        },
    );
    let text = Foreign::all_written(&[&right, &right, &wrong, &right], FOREIGN);
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), text).unwrap();
    let found: Vec<_> = ColumnReader::<VertexFace>::open(file.path()).unwrap().collect();
    assert_eq!(found.len(), 3);
    assert!(found[..2].iter().all(Result::is_ok));
    let error = found[2].as_ref().unwrap_err().to_string();
    assert!(
        error.ends_with(", query 2: expected a time from 0 to 1 as toi, found 2"),
        "{error}"
    );
}
