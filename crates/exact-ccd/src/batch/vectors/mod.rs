//! Batches in vectors: the first filters on several queries at a time.

mod chunks;
mod examine;
mod gaps;
mod instructions;
mod lanes;
mod planes;
mod rows;

pub use instructions::Instructions;

use instructions::dispatch;

use super::run::Batch;
use crate::filter::Touching;
use crate::kind::Kind;
use examine::examine;
use gaps::Separated;

/// Calls `found` with each query of a batch that collides, and its index, in order; those after `until` may
/// be left out. The environment of the thread is the default one.
pub(super) fn run<K: Kind>(batch: Batch<'_, K>) {
    let level = batch.instructions.level();
    if batch.separations.is_contact() {
        dispatch!(level, simd => examine::<_, K, _>(simd, batch, Touching));
    } else {
        let (queries, separations) = (batch.queries, batch.separations);
        let gaps = Separated::<K> { queries, separations };
        dispatch!(level, simd => examine::<_, K, _>(simd, batch, gaps));
    }
}
