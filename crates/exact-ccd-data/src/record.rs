//! Queries with the data that belong to them.

use std::sync::Arc;

use exact_ccd::{Kind, Query};

/// A query from a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<K: Kind> {
    /// The query.
    pub query: Query<K>,
    /// The ground truth, if the file has it: true if the primitives collide.
    pub truth: Option<bool>,
}

/// A query with all that a data set can hold about it.
///
/// Query files hold a part of it, Parquet files all of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Record<K: Kind> {
    /// The query and its ground truth.
    pub sample: Sample<K>,
    /// The number of contact times, −1 for infinitely many.
    pub count: Option<i64>,
    /// The time of impact: the earliest contact time, rounded down to f64.
    pub toi: Option<f64>,
    /// The name of the scene that the query is from.
    pub scene: Option<Arc<str>>,
    /// The ids of the two primitives. They count the vertices of the scene, then its edges, then its faces.
    pub ids: Option<[u64; 2]>,
}

impl<K: Kind> From<Sample<K>> for Record<K> {
    fn from(sample: Sample<K>) -> Self {
        Self {
            sample,
            count: None,
            toi: None,
            scene: None,
            ids: None,
        }
    }
}

/// Returns true for a number of contact times, and for −1.
pub(crate) fn is_count(count: i64) -> bool {
    count >= -1
}

/// A number of contact times as the data sets write it: −1 for infinitely many.
pub(crate) fn number(count: Option<usize>) -> i64 {
    count.map_or(-1, |count| count.try_into().unwrap_or(i64::MAX))
}
