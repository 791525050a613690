//! A query with all that is known about it.

use std::sync::Arc;

use exact_ccd::{ContactTime, Kind};

use crate::queries::Sample;

/// A query with all that is known about it. Query files hold less, files of columns all of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Record<K> {
    /// The query, and whether its primitives collide.
    pub sample: Sample<K>,
    /// How many contact times there are, −1 for infinitely many.
    pub count: Option<i64>,
    /// The time of impact: the earliest contact time, rounded down to f64.
    pub toi: Option<f64>,
    /// The name of the scene that the query is from.
    pub scene: Option<Arc<str>>,
    /// The ids of the two primitives in that scene, which count its vertices, then its edges, then its faces.
    pub ids: Option<[u64; 2]>,
}

impl<K: Kind> Record<K> {
    /// The record with the count and the time of impact that the exact method finds, in place of those it has.
    #[must_use]
    pub fn answered(self) -> Self {
        let times = self.sample.query.contact_times();
        Self {
            count: Some(number(times.count())),
            toi: times.first().map(ContactTime::lower),
            ..self
        }
    }
}

impl<K> From<Sample<K>> for Record<K> {
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

/// A number of contact times as the data sets write it.
pub(crate) fn number(count: Option<usize>) -> i64 {
    count.map_or(-1, |count| count.try_into().unwrap_or(i64::MAX))
}
