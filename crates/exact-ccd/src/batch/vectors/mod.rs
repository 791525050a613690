//! Batches in vectors: the first filters on several queries at a time.

mod chunks;
mod contact;
mod instructions;
mod lanes;
mod planes;
mod rows;
mod within;

pub use instructions::Instructions;

use instructions::dispatch;

use super::run::Batch;
use crate::kind::Kind;

/// Calls `found` with each query of a batch that comes within its separation, and its index, in order;
/// those after `until` may be left out. The environment of the thread is the default one.
pub(super) fn run<K: Kind>(batch: Batch<'_, K>) {
    let level = batch.instructions.level();
    if batch.separations.is_contact() {
        dispatch!(level, simd => contact::examine::<_, K>(simd, batch));
    } else {
        dispatch!(level, simd => within::examine::<_, K>(simd, batch));
    }
}
