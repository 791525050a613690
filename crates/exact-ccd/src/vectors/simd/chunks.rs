//! Chunks of queries: each filter passes on only those that it does not settle.

use core::ops::Range;

use super::planes::LANES;
use crate::tables::Tables;
use crate::vectors::queries::CHUNK;
use crate::vectors::queries::rows_of;
use crate::vectors::row::Row;

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

    /// Passes the indices on.
    pub(super) fn for_each(&self, pass_on: impl FnMut(usize)) {
        self.indices[..self.count].iter().copied().for_each(pass_on);
    }

    /// Passes the queries on by index and rows, eight at a time. The last vector is filled up with
    /// copies of its last query, which have no index.
    #[inline(always)]
    pub(super) fn for_each_eight<'a, K: Tables, V: AsRef<[u32]>>(
        &self,
        rows: &'a [Row],
        queries: &[V],
        mut pass_on: impl FnMut(&[usize], &Eight<'a>),
    ) {
        for indices in self.indices[..self.count].chunks(LANES) {
            let last = indices.len() - 1;
            let eight = core::array::from_fn(
                #[inline(always)]
                |lane| rows_of::<K>(rows, queries[indices[last.min(lane)]].as_ref()),
            );
            pass_on(indices, &eight);
        }
    }
}
