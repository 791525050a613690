//! Blocks of eight boxes, tested against another box at once.

use fearless_simd::prelude::*;
use fearless_simd::{f32x8, mask32x8};

use super::moving_box::MovingBox;

/// The number of boxes in a block.
pub(super) const LANES: usize = 8;

/// A coordinate of eight boxes, by time and axis.
type Sides<const T: usize> = [[[f32; LANES]; 3]; T];

/// Eight boxes, coordinate by coordinate.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Block<const T: usize> {
    lower: Sides<T>,
    upper: Sides<T>,
}

impl<const T: usize> Block<T> {
    pub(super) const EMPTY: Self = Self {
        lower: [[[f32::INFINITY; LANES]; 3]; T],
        upper: [[[f32::NEG_INFINITY; LANES]; 3]; T],
    };

    /// The block of at most eight boxes.
    pub(super) fn of(boxes: &[MovingBox<T>]) -> Self {
        let mut block = Self::EMPTY;
        for (lane, moving) in boxes.iter().enumerate() {
            block.set(lane, moving);
        }
        block
    }

    #[inline(always)]
    pub(super) fn set(&mut self, lane: usize, moving: &MovingBox<T>) {
        for time in 0..T {
            for axis in 0..3 {
                self.lower[time][axis][lane] = moving.lower[time][axis];
                self.upper[time][axis][lane] = moving.upper[time][axis];
            }
        }
    }

    #[inline]
    pub(super) fn get(&self, lane: usize) -> MovingBox<T> {
        let mut moving = MovingBox::EMPTY;
        for time in 0..T {
            for axis in 0..3 {
                moving.lower[time][axis] = self.lower[time][axis][lane];
                moving.upper[time][axis] = self.upper[time][axis][lane];
            }
        }
        moving
    }

    /// The smallest box around all eight.
    pub(super) fn union(&self) -> MovingBox<T> {
        (0..LANES).fold(MovingBox::EMPTY, |union, lane| union.union(&self.get(lane)))
    }

    /// A box of the block.
    #[inline(always)]
    pub(super) fn lane(&self, lane: usize) -> Lane<'_, T> {
        Lane { block: self, lane }
    }

    /// A bit for each box of the block: set if it may meet another box. It is not set if an axis
    /// separates the two at t = 0 and, in the same order, at t = 1, hence at all times in between.
    /// Boxes at rest are separated if they do not overlap.
    #[inline(always)]
    pub(super) fn meeting<S: Simd>(&self, simd: S, other: &impl Moving) -> u32 {
        let separated =
            self.separated(simd, other, 0) | self.separated(simd, other, 1) | self.separated(simd, other, 2);
        (!separated).to_bitmask() as u32
    }

    #[inline(always)]
    fn separated<S: Simd>(&self, simd: S, other: &impl Moving, axis: usize) -> mask32x8<S> {
        let [above, below] = self.sides(simd, other, axis, 0);
        match T {
            1 => above | below,
            _ => {
                let [above_at_end, below_at_end] = self.sides(simd, other, axis, 1);
                (above & above_at_end) | (below & below_at_end)
            }
        }
    }

    /// Masks of the boxes above the other box and of the boxes below it, along an axis.
    #[inline(always)]
    fn sides<S: Simd>(&self, simd: S, other: &impl Moving, axis: usize, time: usize) -> [mask32x8<S>; 2] {
        let lower = f32x8::from_slice(simd, &self.lower[time][axis]);
        let upper = f32x8::from_slice(simd, &self.upper[time][axis]);
        [
            lower.simd_gt(f32x8::splat(simd, other.upper(time, axis))),
            upper.simd_lt(f32x8::splat(simd, other.lower(time, axis))),
        ]
    }
}

/// A box that moves, coordinate by coordinate.
pub(super) trait Moving {
    fn lower(&self, time: usize, axis: usize) -> f32;
    fn upper(&self, time: usize, axis: usize) -> f32;
}

impl<const T: usize> Moving for MovingBox<T> {
    #[inline(always)]
    fn lower(&self, time: usize, axis: usize) -> f32 {
        self.lower[time][axis]
    }

    #[inline(always)]
    fn upper(&self, time: usize, axis: usize) -> f32 {
        self.upper[time][axis]
    }
}

/// A box in a block.
pub(super) struct Lane<'a, const T: usize> {
    block: &'a Block<T>,
    lane: usize,
}

impl<const T: usize> Moving for Lane<'_, T> {
    #[inline(always)]
    fn lower(&self, time: usize, axis: usize) -> f32 {
        self.block.lower[time][axis][self.lane]
    }

    #[inline(always)]
    fn upper(&self, time: usize, axis: usize) -> f32 {
        self.block.upper[time][axis][self.lane]
    }
}
