//! A batch of one kind: in vectors, or query by query.

use super::queries::{Batch, Found, Passed};
use super::simd::{self, Instructions};
use crate::environment;
use crate::tables::Tables;

/// Passes the queries of a batch on, in order, by vectors of some instructions.
pub(crate) fn run<K: Tables, V: AsRef<[u32]>>(batch: Batch<'_, K, V>, instructions: Instructions) {
    let Batch { until, passed, .. } = batch;
    match passed {
        Passed::Unsettled(_) => run_all(Batch { passed, ..batch }, instructions),
        Passed::Colliding(found) => {
            let found: Found<'_, K> = &mut |index, points, decided| {
                if let Some(decided) = decided.until(points, until) {
                    found(index, points, decided);
                }
            };
            let passed = Passed::Colliding(found);
            run_all(Batch { passed, ..batch }, instructions);
        }
    }
}

/// The same, but collisions after the last time may be passed on too.
fn run_all<K: Tables, V: AsRef<[u32]>>(batch: Batch<'_, K, V>, instructions: Instructions) {
    if environment::is_default() {
        simd::run(batch, instructions);
    } else {
        batch.one_by_one();
    }
}
