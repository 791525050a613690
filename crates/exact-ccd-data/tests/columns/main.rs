//! Parquet files: lossless round trips, files of other software, and the errors of damaged ones.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod damage;
mod foreign;
mod hostile;
mod round_trip;

use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

use exact_ccd::{Kind, Point, Query, VertexFace};
use exact_ccd_data::{ColumnReader, ColumnWriter, DataError, Record, Sample};
use tempfile::TempDir;

fn written<K: Kind>(records: &[Record<K>]) -> Vec<u8> {
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

    fn read<K: Kind>(&self, bytes: &[u8]) -> Result<Vec<Record<K>>, DataError> {
        fs::write(self.file(), bytes).unwrap();
        ColumnReader::open(&self.file())?.collect()
    }

    /// The error, without the name of the file at its beginning.
    #[track_caller]
    fn error<K: Kind>(&self, bytes: &[u8]) -> String {
        let error = self.read::<K>(bytes).err().unwrap().to_string();
        error
            .strip_prefix(self.file().to_str().unwrap())
            .unwrap()
            .to_owned()
    }
}

/// The fields of a record, each f64 as its bits.
fn bits<K: Kind>(record: &Record<K>) -> impl PartialEq + std::fmt::Debug + use<K> {
    let Record {
        sample,
        count,
        toi,
        scene,
        ids,
    } = record.clone();
    let points = sample.query.points().iter().flat_map(AsRef::as_ref);
    let points: Vec<_> = points.map(|point| point.map(f64::to_bits)).collect();
    (points, sample.truth, count, toi.map(f64::to_bits), scene, ids)
}

type Rest = (
    Option<bool>,
    Option<i64>,
    Option<f64>,
    Option<String>,
    Option<[u64; 2]>,
);

/// A record of the first of these points at t = 0 and at t = 1: as many as the kind has.
fn record<K: Kind>(points: [[Point; 4]; 2], (truth, count, toi, scene, ids): Rest) -> Record<K> {
    let [t0, t1] = points.map(|points| {
        let mut first = K::Points::default();
        first
            .as_mut()
            .copy_from_slice(&points[..K::KIND.point_names().len()]);
        first
    });
    Record {
        sample: Sample {
            query: Query::new(t0, t1).unwrap(),
            truth,
        },
        count,
        toi,
        scene: scene.map(Arc::from),
        ids,
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
