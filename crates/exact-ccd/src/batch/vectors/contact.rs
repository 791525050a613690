//! The filters of contact on chunks of queries.

use fearless_simd::Simd;

use super::chunks::{Unsettled, for_each_chunk};
use super::{planes, rows};
use crate::batch::run::{Batch, query, rows_of};
use crate::collision::Collision;
use crate::filter::{self, Decision};
use crate::kind::Kind;

/// Calls `found` with each query of a batch that collides, and its index, in order.
#[inline(always)]
pub(super) fn examine<S: Simd, K: Kind>(simd: S, batch: Batch<'_, K>) {
    let Batch {
        rows, queries, found, ..
    } = batch;
    for_each_chunk(
        queries.len(),
        #[inline(always)]
        |chunk| {
            let mut near = Unsettled::new();
            for index in chunk {
                let is_settled = rows::are_separated::<S, K>(simd, rows_of::<K>(rows, &queries[index]));
                near.push_unless(is_settled, index);
            }
            near.for_each_eight::<K>(
                rows,
                queries,
                #[inline(always)]
                |indices, eight| {
                    let rest = planes::screen::<S, K>(simd, eight);
                    for (lane, &index) in indices.iter().enumerate() {
                        if rest.lanes >> lane & 1 != 0 {
                            let query = query(eight[lane]);
                            let decision = if rest.out_of_range >> lane & 1 == 0 {
                                filter::decide_near_plane(&query, &rest.cubic(lane))
                            } else {
                                Decision::Unknown
                            };
                            if let Ok(collision) = Collision::from_decision(&query, decision) {
                                found(index, collision);
                            }
                        }
                    }
                },
            );
        },
    );
}
