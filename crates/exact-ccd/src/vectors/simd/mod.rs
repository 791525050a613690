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

use super::queries::{Batch, Passed};
use crate::filter::Touching;
use crate::tables::Tables;
use examine::examine;
use gaps::Separated;

/// Passes the queries of a batch on, in order; those that collide after `until` may be left out. The
/// environment of the thread is the default one.
pub(super) fn run<K: Tables, V: AsRef<[u32]>>(batch: Batch<'_, K, V>, instructions: Instructions) {
    let level = instructions.level();
    // Unsettled queries are passed on by the code for distances above 0, which is right for 0 too. The copy
    // for contact passes on what collides alone.
    if batch.separations.is_contact() && matches!(batch.passed, Passed::Colliding(_)) {
        dispatch!(level, simd => examine::<_, K, _, _>(simd, batch, Touching));
    } else {
        let (queries, separations) = (batch.queries, batch.separations);
        let gaps = Separated::<K, V>::new(queries, separations);
        dispatch!(level, simd => examine::<_, K, _, _>(simd, batch, gaps));
    }
}
