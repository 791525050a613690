//! The labels of boxes: two boxes with a common label are no pair.

use fearless_simd::prelude::*;
use fearless_simd::{mask32x8, u32x8};

use super::block::LANES;

/// The labels of boxes in blocks of eight, as many for each box.
///
/// The labels of a primitive are its vertices. Boxes of neighbours in a mesh always meet, and most pairs
/// that meet on a smooth surface are neighbours.
#[derive(Clone, Debug, Default)]
pub(super) struct Labels {
    /// The number of labels of each box.
    count: usize,
    /// Block by block, and in a block label by label. The places after the last box have no meaning.
    rows: Vec<[u32; LANES]>,
}

/// The labels of a block: a row for each of a box's labels.
pub(super) type LabelRows<'a> = &'a [[u32; LANES]];

impl Labels {
    /// The labels of boxes with these indices.
    pub(super) fn new<const N: usize>(ids: &[u32], labels: impl Fn(u32) -> [u32; N]) -> Self {
        let mut rows = Vec::with_capacity(N * ids.len().div_ceil(LANES));
        for eight in ids.chunks(LANES) {
            let mut block = [[0; LANES]; N];
            for (lane, &id) in eight.iter().enumerate() {
                for (row, label) in block.iter_mut().zip(labels(id)) {
                    row[lane] = label;
                }
            }
            rows.extend(block);
        }
        Self { count: N, rows }
    }

    /// Those of a block.
    #[inline(always)]
    pub(super) fn of(&self, block: usize) -> LabelRows<'_> {
        &self.rows[self.count * block..][..self.count]
    }

    /// Those of the boxes at some places.
    pub(super) fn only(&self, places: &[usize]) -> Self {
        let mut rows = Vec::with_capacity(self.count * places.len().div_ceil(LANES));
        for eight in places.chunks(LANES) {
            for label in 0..self.count {
                let mut row = [0; LANES];
                for (to, &place) in row.iter_mut().zip(eight) {
                    *to = self.of(place / LANES)[label][place % LANES];
                }
                rows.push(row);
            }
        }
        Self { rows, ..*self }
    }

    /// Those of one block in every `stride`.
    pub(super) fn sample(&self, stride: usize) -> Self {
        let blocks = self.rows.chunks(self.count.max(1)).step_by(stride);
        Self {
            rows: blocks.flatten().copied().collect(),
            ..*self
        }
    }
}

/// A bit for each box of a block: set if it has a label in common with the box in a lane of another block.
#[inline(always)]
pub(super) fn common<S: Simd>(simd: S, rows: LabelRows<'_>, others: LabelRows<'_>, lane: usize) -> u32 {
    let lane = lane % LANES;
    // The kinds of pairs of a mesh, without a loop.
    match (others, rows) {
        ([a], [b0, b1, b2]) => {
            let a = u32x8::splat(simd, a[lane]);
            equal(simd, b0, a) | equal(simd, b1, a) | equal(simd, b2, a)
        }
        ([a0, a1], [b0, b1]) => {
            let (a0, a1) = (u32x8::splat(simd, a0[lane]), u32x8::splat(simd, a1[lane]));
            (equal(simd, b0, a0) | equal(simd, b0, a1)) | (equal(simd, b1, a0) | equal(simd, b1, a1))
        }
        _ => {
            let mut common = mask32x8::splat(simd, false);
            for other in others {
                for row in rows {
                    common |= equal(simd, row, u32x8::splat(simd, other[lane]));
                }
            }
            common
        }
    }
    .to_bitmask() as u32
}

#[inline(always)]
fn equal<S: Simd>(simd: S, row: &[u32; LANES], label: u32x8<S>) -> mask32x8<S> {
    u32x8::from_slice(simd, row).simd_eq(label)
}
