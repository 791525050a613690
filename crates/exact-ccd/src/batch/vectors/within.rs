//! The filters of separation on chunks of queries.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f64x8};

use super::chunks::{Unsettled, for_each_chunk};
use super::planes::{LANES, transposed};
use super::rows;
use crate::batch::run::{Batch, query, rows_of};
use crate::kind::Kind;
use crate::separation::Screening;

/// The least time until which a step is examined, 2⁻⁶⁰.
const LEAST_UNTIL: f64 = f64::from_bits((1023 - 60) << 52);

/// Calls `found` with each query of a batch that comes within its separation, and its index, in order;
/// those after `until` may be left out.
#[inline(always)]
pub(super) fn examine<S: Simd, K: Kind>(simd: S, batch: Batch<'_, K>) {
    let Batch {
        rows,
        queries,
        separations,
        until,
        found,
        ..
    } = batch;
    // Above 0: a proof that begins at t = 0 ends later. What is found after `until` is dropped by `found`.
    let until = until.clamp(LEAST_UNTIL, 1.0);
    let separation = |index: usize| {
        let (a, b) = queries[index].as_ref().split_at(K::FIRST);
        separations.between(a, b)
    };
    let distances = |indices: &[usize]| {
        let mut d = [0.0; LANES];
        for (d, &index) in d.iter_mut().zip(indices) {
            *d = separation(index).get();
        }
        d
    };
    for_each_chunk(
        queries.len(),
        #[inline(always)]
        |chunk| {
            let (mut near, mut approaching) = (Unsettled::new(), Unsettled::new());
            for index in chunk {
                let rows = rows_of::<K>(rows, &queries[index]);
                near.push_unless(
                    rows::are_beyond::<S, K>(simd, rows, separation(index).get()),
                    index,
                );
            }
            near.for_each_eight::<K>(
                rows,
                queries,
                #[inline(always)]
                |indices, eight| {
                    let points = transposed(simd, eight);
                    let screening =
                        Screening::new::<K>(&points, f64x8::from_slice(simd, &distances(indices)));
                    let beyond = screening.planes_are_beyond::<K>(&points).to_bitmask();
                    for (lane, &index) in indices.iter().enumerate() {
                        approaching.push_unless(beyond >> lane & 1 != 0, index);
                    }
                },
            );
            approaching.for_each_eight::<K>(
                rows,
                queries,
                #[inline(always)]
                |indices, eight| {
                    let points = transposed(simd, eight);
                    let screening =
                        Screening::new::<K>(&points, f64x8::from_slice(simd, &distances(indices)));
                    let free: [f64; LANES] = screening.free_until::<K>(until).into();
                    for (lane, &index) in indices.iter().enumerate() {
                        if free[lane] < until {
                            let query = query(eight[lane]);
                            if let Some(collision) =
                                query.collision_between(separation(index), [free[lane], until])
                            {
                                found(index, collision);
                            }
                        }
                    }
                },
            );
        },
    );
}
