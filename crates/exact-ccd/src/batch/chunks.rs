//! The filters on chunks of queries: each filter passes on only those that it does not settle.

use core::ops::Range;

use fearless_simd::{Simd, dispatch};

use super::instructions::Instructions;
use super::planes::{self, LANES};
use super::row::Row;
use super::rows;
use crate::collision::Collision;
use crate::environment::flushes_subnormals;
use crate::filter::{self, Decision};
use crate::kind::Kind;
use crate::query::Query;

/// The number of queries that go through one filter before the next filter.
pub(super) const CHUNK: usize = 256;

/// The callback for collisions. Behind a pointer: contacts are few, and the vector code is compiled
/// only once for all callbacks.
pub(super) type Found<'f, K> = &'f mut dyn for<'a> FnMut(usize, Collision<'a, K>);

/// Calls `found` with each query of rows that collides, and its index, in order. All indices
/// of rows exist.
pub(super) fn collisions<K: Kind>(
    instructions: Instructions,
    rows: &[Row],
    queries: &[K::Vertices],
    found: Found<'_, K>,
) {
    if flushes_subnormals() {
        return without_filters::<K>(rows, queries, found);
    }
    dispatch!(instructions.level(), simd => with_filters::<_, K>(simd, rows, queries, found));
}

/// The same without the filters.
#[cold]
fn without_filters<K: Kind>(rows: &[Row], queries: &[K::Vertices], found: Found<'_, K>) {
    for (index, vertices) in queries.iter().enumerate() {
        let query = query_of(rows, vertices);
        if let Ok(collision) = Collision::from_decision(&query, Decision::Unknown) {
            found(index, collision);
        }
    }
}

#[inline(always)]
fn with_filters<S: Simd, K: Kind>(simd: S, rows: &[Row], queries: &[K::Vertices], found: Found<'_, K>) {
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

/// Calls a function with the indices of each chunk of queries.
#[inline(always)]
pub(super) fn for_each_chunk(count: usize, mut examine: impl FnMut(Range<usize>)) {
    for begin in (0..count).step_by(CHUNK) {
        examine(begin..count.min(begin + CHUNK));
    }
}

/// The rows of eight queries.
pub(super) type Eight<'a> = [[&'a Row; 4]; LANES];

/// The queries of a chunk that the filters so far do not settle, by their indices, in order.
pub(super) struct Unsettled {
    indices: [usize; CHUNK],
    count: usize,
}

impl Unsettled {
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self {
            indices: [0; CHUNK],
            count: 0,
        }
    }

    /// Appends a query, of at most a chunk, that is not settled.
    #[inline(always)]
    pub(super) fn push_unless(&mut self, is_settled: bool, index: usize) {
        // Without a branch, which would be hard to predict.
        self.indices[self.count] = index;
        self.count += usize::from(!is_settled);
    }

    /// Passes the queries on by index and rows, eight at a time. The last vector is filled up with
    /// copies of its last query, which have no index.
    #[inline(always)]
    pub(super) fn for_each_eight<'a, K: Kind>(
        &self,
        rows: &'a [Row],
        queries: &[K::Vertices],
        mut pass_on: impl FnMut(&[usize], &Eight<'a>),
    ) {
        for indices in self.indices[..self.count].chunks(LANES) {
            let last = indices.len() - 1;
            let eight = core::array::from_fn(
                #[inline(always)]
                |lane| rows_of::<K>(rows, &queries[indices[last.min(lane)]]),
            );
            pass_on(indices, &eight);
        }
    }
}

/// The rows of x₀ … x₃.
#[inline(always)]
pub(super) fn rows_of<'a, K: Kind>(rows: &'a [Row], vertices: &K::Vertices) -> [&'a Row; 4] {
    K::LAYOUT.map(|i| &rows[vertices.as_ref()[i] as usize])
}

/// The query of vertices whose rows exist, with finite coordinates.
pub(super) fn query_of<K: Kind>(rows: &[Row], vertices: &K::Vertices) -> Query<K> {
    query(rows_of::<K>(rows, vertices))
}

pub(super) fn query<K: Kind>(rows: [&Row; 4]) -> Query<K> {
    let [[a0, a1], [b0, b1], [c0, c1], [d0, d1]] = rows.map(Row::points);
    Query::from_finite([[a0, b0, c0, d0], [a1, b1, c1, d1]])
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use proptest::array::{uniform2, uniform4};
    use proptest::collection::vec;
    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    use super::*;
    use crate::{ContactTimes, EdgeEdge, VertexFace};

    type Answers = Vec<(usize, ContactTimes, crate::Impact)>;

    fn answers<K: Kind>(collisions: impl FnOnce(Found<'_, K>)) -> Answers {
        let mut answers = Vec::new();
        collisions(&mut |index, collision| {
            answers.push((index, collision.contact_times(), collision.impact()));
        });
        answers
    }

    fn agree<K: Kind>(rows: &[Row], queries: &[K::Vertices]) {
        let instructions = Instructions::best();
        let with: Answers = answers::<K>(|found| collisions::<K>(instructions, rows, queries, found));
        let without: Answers = answers::<K>(|found| without_filters::<K>(rows, queries, found));
        assert_eq!(with.len(), without.len());
        for (with, without) in with.into_iter().zip(without) {
            assert_eq!((with.0, with.1), (without.0, without.1));
            assert_eq!(with.2.time, without.2.time);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            cases: 200,
            failure_persistence: None,
            rng_seed: RngSeed::Fixed(0),
            ..ProptestConfig::default()
        })]

        /// A thread that flushes subnormal numbers finds the same contacts as others: in units of 1
        /// and of the smallest subnormal number.
        #[test]
        fn the_answers_do_not_depend_on_the_filters(
            points in vec(uniform2([-4..=4i8, -4..=4i8, -4..=4i8]), 12),
            queries in vec(uniform4(0..12_u32), 30),
            is_subnormal: bool,
        ) {
            let unit = if is_subnormal { f64::from_bits(1) } else { 1.0 };
            let rows: Vec<Row> = points
                .iter()
                .map(|ends| {
                    let [start, end] = ends.map(|point| point.map(|x| f64::from(x) * unit));
                    Row::new(start, end)
                })
                .collect();
            agree::<VertexFace>(&rows, &queries);
            agree::<EdgeEdge>(&rows, &queries);
        }
    }
}
