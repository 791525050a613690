//! The filters of separation on chunks of queries.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, dispatch, f64x8};

use super::chunks::{self, Found, Unsettled, for_each_chunk, query, query_of, rows_of};
use super::instructions::Instructions;
use super::planes::{LANES, transposed};
use super::row::Row;
use super::rows;
use crate::environment::flushes_subnormals;
use crate::kind::Kind;
use crate::query::Query;
use crate::separation::{Screening, Separations};

/// A batch of one kind: calls `found` with each query of rows that comes within its separation at a time
/// not above `until`, and its index, in order. All indices of rows exist.
#[expect(
    unnameable_types,
    reason = "an argument of a hidden function of a sealed trait"
)]
pub struct Batch<'a, K: Kind> {
    pub(super) instructions: Instructions,
    pub(super) rows: &'a [Row],
    pub(super) queries: &'a [K::Vertices],
    pub(super) separations: Separations<'a>,
    pub(super) until: f64,
    pub(super) found: Found<'a, K>,
}

impl<K: Kind> Batch<'_, K> {
    pub(crate) fn run(self) {
        let Self {
            instructions,
            rows,
            queries,
            separations,
            until,
            found,
        } = self;
        let found: Found<'_, K> = &mut |index, collision| {
            if until >= 1.0 || collision.first_contact_time().is_at_most(until) {
                found(index, collision);
            }
        };
        if separations.is_contact() {
            return chunks::collisions::<K>(instructions, rows, queries, found);
        }
        if flushes_subnormals() {
            return one_by_one::<K>(rows, queries, separations, found);
        }
        dispatch!(instructions.level(), simd => with_filters::<_, K>(simd, rows, queries, separations, until, found));
    }
}

/// The same for single queries, which use no filter then.
#[cold]
fn one_by_one<K: Kind>(
    rows: &[Row],
    queries: &[K::Vertices],
    separations: Separations<'_>,
    found: Found<'_, K>,
) {
    for (index, vertices) in queries.iter().enumerate() {
        let (a, b) = vertices.as_ref().split_at(K::FIRST);
        let query: Query<K> = query_of(rows, vertices);
        if let Some(collision) = query.collision_within(separations.between(a, b)) {
            found(index, collision);
        }
    }
}

/// The least time until which a step is examined, 2⁻⁶⁰.
const LEAST_UNTIL: f64 = f64::from_bits((1023 - 60) << 52);

#[inline(always)]
fn with_filters<S: Simd, K: Kind>(
    simd: S,
    rows: &[Row],
    queries: &[K::Vertices],
    separations: Separations<'_>,
    until: f64,
    found: Found<'_, K>,
) {
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
