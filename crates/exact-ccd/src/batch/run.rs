//! A batch of one kind: in vectors, or query by query.

use super::queries::{Batch, Found, Passed};
use super::vectors::{self, Instructions};
use crate::environment;
use crate::kind::Kind;

/// Passes the queries of a batch on, in order, by vectors of some instructions.
pub(crate) fn run<K: Kind>(batch: Batch<'_, K>, instructions: Instructions) {
    let Batch { until, passed, .. } = batch;
    match passed {
        Passed::Unsettled(_) => run_all(Batch { passed, ..batch }, instructions),
        Passed::Colliding(found) => {
            let found: Found<'_, K> = &mut |index, collision| {
                if let Some(collision) = collision.until(until) {
                    found(index, collision);
                }
            };
            let passed = Passed::Colliding(found);
            run_all(Batch { passed, ..batch }, instructions);
        }
    }
}

/// The same, but collisions after the last time may be passed on too.
fn run_all<K: Kind>(batch: Batch<'_, K>, instructions: Instructions) {
    if environment::is_default() {
        vectors::run(batch, instructions);
    } else {
        batch.one_by_one();
    }
}
