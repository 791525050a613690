//! Eight boxes, each tested against another one at the same time.

use fearless_simd::prelude::*;
use fearless_simd::{Level, f32x8};

use super::moving_box::MovingBox;

/// How many boxes are side by side.
pub(super) const LANES: usize = 8;

/// The vector instructions for tests of blocks: no more than AVX2, whose vectors have eight places too, and which combines
/// comparisons in half of the time that the mask registers of AVX-512 take.
pub(super) fn level() -> Level {
    let level = Level::new();
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    let level = level.as_avx2().map_or(level, Simd::level);
    level
}

/// A coordinate of eight boxes, by time and axis.
type Sides = [[[f32; LANES]; 3]; 2];

/// Eight boxes, coordinate by coordinate.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Block {
    lower: Sides,
    upper: Sides,
}

impl Block {
    pub(super) const EMPTY: Self = Self {
        lower: [[[f32::INFINITY; LANES]; 3]; 2],
        upper: [[[f32::NEG_INFINITY; LANES]; 3]; 2],
    };

    #[inline(always)]
    pub(super) fn set(&mut self, lane: usize, moving: &MovingBox) {
        for time in 0..2 {
            for axis in 0..3 {
                self.lower[time][axis][lane] = moving.lower[4 * time + axis];
                self.upper[time][axis][lane] = moving.upper[4 * time + axis];
            }
        }
    }

    #[inline]
    pub(super) fn get(&self, lane: usize) -> MovingBox {
        let mut moving = MovingBox::EMPTY;
        for time in 0..2 {
            for axis in 0..3 {
                moving.lower[4 * time + axis] = self.lower[time][axis][lane];
                moving.upper[4 * time + axis] = self.upper[time][axis][lane];
            }
        }
        moving
    }

    /// The smallest box around all eight.
    pub(super) fn union(&self) -> MovingBox {
        (0..LANES).fold(MovingBox::EMPTY, |union, lane| union.union(&self.get(lane)))
    }

    /// One of the boxes.
    #[inline(always)]
    pub(super) fn lane(&self, lane: usize) -> Lane<'_> {
        Lane { block: self, lane }
    }

    /// Which of the boxes may meet another one, as a bit for each: all but those that an axis separates at t = 0 and, the
    /// same way round, at t = 1, hence at all times between. Boxes that rest are separated if they do not overlap.
    #[inline(always)]
    pub(super) fn meeting<S: Simd>(&self, simd: S, other: &impl Moving) -> u32 {
        let load = |row: &[f32; LANES]| f32x8::from_slice(simd, row);
        let all = |x: f32| f32x8::splat(simd, x);
        let above =
            |time: usize, axis: usize| load(&self.lower[time][axis]).simd_gt(all(other.upper(time, axis)));
        let below =
            |time: usize, axis: usize| load(&self.upper[time][axis]).simd_lt(all(other.lower(time, axis)));
        let separated = ((above(0, 0) & above(1, 0)) | (below(0, 0) & below(1, 0)))
            | ((above(0, 1) & above(1, 1)) | (below(0, 1) & below(1, 1)))
            | ((above(0, 2) & above(1, 2)) | (below(0, 2) & below(1, 2)));
        (!separated).to_bitmask() as u32
    }
}

/// A box that moves, coordinate by coordinate.
pub(super) trait Moving {
    fn lower(&self, time: usize, axis: usize) -> f32;
    fn upper(&self, time: usize, axis: usize) -> f32;
}

impl Moving for MovingBox {
    #[inline(always)]
    fn lower(&self, time: usize, axis: usize) -> f32 {
        self.lower[4 * time + axis]
    }

    #[inline(always)]
    fn upper(&self, time: usize, axis: usize) -> f32 {
        self.upper[4 * time + axis]
    }
}

/// A box in a block.
pub(super) struct Lane<'a> {
    block: &'a Block,
    lane: usize,
}

impl Moving for Lane<'_> {
    #[inline(always)]
    fn lower(&self, time: usize, axis: usize) -> f32 {
        self.block.lower[time][axis][self.lane]
    }

    #[inline(always)]
    fn upper(&self, time: usize, axis: usize) -> f32 {
        self.block.upper[time][axis][self.lane]
    }
}
