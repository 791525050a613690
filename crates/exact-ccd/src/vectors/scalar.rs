//! Batches on processors without vectors: query by query, with the same answers.

use super::queries::Batch;
use crate::tables::Tables;

/// A set of vector instructions of this processor: the empty one.
///
/// No answer depends on it. A choice is useful for tests and measurements only.
#[derive(Clone, Copy, Debug, Default)]
pub struct Instructions;

impl Instructions {
    /// The widest set of this processor.
    #[must_use]
    pub fn best() -> Self {
        Self
    }

    /// All sets of this processor, from the narrowest to the widest.
    pub fn available() -> impl Iterator<Item = Self> {
        core::iter::once(Self)
    }
}

/// Passes the queries of a batch on, in order.
pub(super) fn run<K: Tables, V: AsRef<[u32]>>(batch: Batch<'_, K, V>, Instructions: Instructions) {
    batch.one_by_one();
}
