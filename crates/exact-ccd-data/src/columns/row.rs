//! A query out of the fields of a row.

use std::sync::Arc;

use exact_ccd::Kind;
use exact_ccd_files::excerpt;
use parquet::data_type::ByteArray;

use super::coordinates;
use super::problem::RecordProblem;
use crate::query_points;
use crate::record::{Record, Sample, is_count};

/// The fields of a row. `None` is a null, or a list of coordinates with a null in it.
pub(super) struct Row {
    pub(super) kind: Option<ByteArray>,
    pub(super) points: Option<Vec<f64>>,
    pub(super) truth: Option<bool>,
    pub(super) count: Option<i64>,
    pub(super) toi: Option<f64>,
    pub(super) scene: Option<ByteArray>,
    pub(super) ids: [Option<i64>; 2],
}

impl Row {
    /// The query and its data.
    pub(super) fn record<K: Kind>(self) -> Result<Record<K>, RecordProblem> {
        let kind = self.kind.as_ref().map(ByteArray::data);
        if kind != Some(K::KIND.short().as_bytes()) {
            let found = kind.map_or("null".into(), excerpt);
            return Err(RecordProblem::field("kind", K::KIND.short(), found));
        }
        let expected = coordinates::<K>();
        let Some(points) = self.points.filter(|points| points.len() == expected) else {
            return Err(RecordProblem::Points { expected });
        };
        let (points, _) = points.as_chunks::<3>();
        if let Some(count) = self.count.filter(|&count| !is_count(count)) {
            return Err(RecordProblem::field("count", "a number of contacts or -1", count));
        }
        if let Some(toi) = self.toi.filter(|&toi| !is_time(toi)) {
            return Err(RecordProblem::field("toi", "a time from 0 to 1", toi));
        }
        let scene = self.scene.as_ref().map(|name| {
            let text = str::from_utf8(name.data());
            text.map_err(|_| RecordProblem::field("scene", "UTF-8", excerpt(name.data())))
        });
        let ids = match self.ids {
            [None, None] => None,
            [Some(a @ 0..), Some(b @ 0..)] => Some([a, b].map(i64::unsigned_abs)),
            ids => {
                let found = ids.map(|id| id.map_or("null".to_owned(), |id| id.to_string()));
                let expected = "two ids of 0 or more, or none";
                return Err(RecordProblem::field(
                    "id_a and id_b",
                    expected,
                    found.join(" and "),
                ));
            }
        };
        Ok(Record {
            sample: Sample {
                query: query_points::query(points)?,
                truth: self.truth,
            },
            count: self.count,
            toi: self.toi,
            scene: scene.transpose()?.map(Arc::from),
            ids,
        })
    }
}

/// Returns true for a time of the step.
pub(super) fn is_time(toi: f64) -> bool {
    (0.0..=1.0).contains(&toi)
}
