//! The filters on chunks of queries.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f64x8};

use super::chunks::{Unsettled, for_each_chunk};
use super::gaps::Gaps;
use super::planes::{LANES, screen, transposed};
use super::rows;
use crate::decided::Decided;
use crate::filter::{Decision, Gap, Hull, LEAST_UNTIL, decide_between, decide_near_plane, free_until};
use crate::tables::{Points, Tables};
use crate::values::Separation;
use crate::vectors::queries::{Batch, Found, Passed, points_of, rows_of};

/// Passes the queries of a batch on, in order; those that collide after `until` may be left out.
#[inline(always)]
pub(super) fn examine<S: Simd, K: Tables, V: AsRef<[u32]>, G: Gaps>(
    simd: S,
    batch: Batch<'_, K, V>,
    gaps: G,
) {
    let Batch {
        rows,
        queries,
        until,
        mut passed,
        ..
    } = batch;
    let until = until.clamp(LEAST_UNTIL, 1.0);
    let report =
        |found: &mut Found<'_, K>, index: usize, points: &Points<f64>, separation, decision: Decision| {
            if let Ok(decided) = Decided::from_filters(points, separation, decision) {
                found(index, points, decided);
            }
        };
    for_each_chunk(
        queries.len(),
        #[inline(always)]
        |chunk| {
            let (mut near, mut approaching) = (Unsettled::new(), Unsettled::new());
            for index in chunk {
                let rows = rows_of::<K>(rows, queries[index].as_ref());
                near.push_unless(rows::are_beyond::<S, K, _>(simd, rows, gaps.of(index)), index);
            }
            near.for_each_eight::<K, V>(
                rows,
                queries,
                #[inline(always)]
                |indices, eight| {
                    let rest = screen::<S, K, _>(simd, eight, gaps.of_eight(simd, indices));
                    for (lane, &index) in indices.iter().enumerate() {
                        let is_settled = rest.settled >> lane & 1 != 0;
                        if <G::One as Gap<f64>>::IS_POSITIVE {
                            approaching.push_unless(is_settled, index);
                        } else if !is_settled && let Passed::Colliding(found) = &mut passed {
                            let points = points_of::<K>(rows, queries[index].as_ref());
                            let decision = match rest.cubic(lane) {
                                Some(cubic) => decide_near_plane::<K>(&points, &cubic, until),
                                None => Decision::Unknown,
                            };
                            report(found, index, &points, Separation::ZERO, decision);
                        }
                    }
                },
            );
            if !<G::One as Gap<f64>>::IS_POSITIVE {
                return;
            }
            let found = match &mut passed {
                Passed::Colliding(found) => found,
                Passed::Unsettled(unsettled) => return approaching.for_each(unsettled),
            };
            approaching.for_each_eight::<K, V>(
                rows,
                queries,
                #[inline(always)]
                |indices, eight| {
                    let hull = Hull::new::<K>(&transposed(simd, eight));
                    let gaps_of_eight = gaps.of_eight(simd, indices);
                    let d = gaps_of_eight.value(f64x8::splat(simd, 0.0));
                    let free: [f64; LANES] = free_until::<K, _>(&hull, d, until).into();
                    for (lane, &index) in indices.iter().enumerate() {
                        if free[lane] < until {
                            let points = points_of::<K>(rows, queries[index].as_ref());
                            let d = gaps.separation(index);
                            let decision = decide_between::<K>(&points, d, [free[lane], until]);
                            report(found, index, &points, d, decision);
                        }
                    }
                },
            );
        },
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::{EdgeEdge, VertexFace};
    use crate::vectors::row::Row;
    use crate::vectors::simd::instructions::{Instructions, dispatch};

    /// Queries at random: some are free in one stretch of time, some in many, and some collide.
    #[test]
    fn lanes_are_free_until_the_times_of_single_queries() {
        fn compare<K: Tables>() {
            let mut random = fastrand::Rng::with_seed(35);
            let (mut halved, mut free) = (0, 0);
            for _ in 0..300 {
                let mut points = || [(); 4].map(|()| [(); 3].map(|()| 2.0 * random.f64() - 1.0));
                let queries: [Points<f64>; LANES] = [(); LANES].map(|()| [points(), points()]);
                let distances = [(); LANES].map(|()| 0.5 * random.f64());
                let single: [f64; LANES] = core::array::from_fn(|lane| {
                    free_until::<K, f64>(&Hull::new::<K>(&queries[lane]), distances[lane], 1.0)
                });
                let rows = queries
                    .map(|[start, end]| [0, 1, 2, 3].map(|point: usize| Row::new(start[point], end[point])));
                let eight = rows.each_ref().map(<[Row; 4]>::each_ref);
                for instructions in Instructions::available() {
                    let lanes: [f64; LANES] = dispatch!(instructions.level(), simd => {
                        let hull = Hull::new::<K>(&transposed(simd, &eight));
                        free_until::<K, _>(&hull, f64x8::from_slice(simd, &distances), 1.0).into()
                    });
                    assert_eq!(lanes, single);
                }
                halved += single.iter().filter(|&&time| time > 0.0 && time < 1.0).count();
                free += single.iter().filter(|&&time| time == 1.0).count();
            }
            assert!(halved > 100 && free > 100, "{halved} {free}");
        }
        compare::<VertexFace>();
        compare::<EdgeEdge>();
    }
}
