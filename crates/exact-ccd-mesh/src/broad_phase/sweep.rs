//! Sweep and prune.

use core::ops::ControlFlow;

use fearless_simd::Simd;
use rayon::prelude::*;

use super::boxes::Boxes;
use super::moving_box::MovingBox;
use super::pairs::Pairs;
use super::vectors::vectorized;
use super::{BoxPairs, PairSink};

/// Sweep and prune along one axis, over blocks of eight boxes that are near each other: J. Cohen,
/// M. Lin, D. Manocha and M. Ponamgi, *I-COLLIDE: An interactive and exact collision detection
/// system for large-scale environments*, 1995.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sweep;

/// The number of blocks that a thread searches for in one task.
const GRAIN: usize = 32;

impl<const T: usize> BoxPairs<T> for Sweep {
    fn between(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        let axis = longest_axis(b);
        let [of_a, of_b] = [a, b].map(|boxes| Interval::sorted(boxes, axis));
        // Of two overlapping intervals, one begins inside the other.
        of_a.par_chunks(GRAIN).try_for_each(|grain| {
            let after = |interval: &Interval| of_b.partition_point(|other| other.lower < interval.lower);
            let pairs = Pairs::between(a, b, sink);
            vectorized!(simd => sweep(simd, grain, |i| (&of_b[after(i)..], false), pairs))
        })?;
        of_b.par_chunks(GRAIN).try_for_each(|grain| {
            let after = |interval: &Interval| of_a.partition_point(|other| other.lower <= interval.lower);
            let pairs = Pairs::between(a, b, sink);
            vectorized!(simd => sweep(simd, grain, |i| (&of_a[after(i)..], true), pairs))
        })
    }

    fn within(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        let intervals = Interval::sorted(boxes, longest_axis(boxes));
        intervals.par_chunks(GRAIN).try_for_each(|grain| {
            let from = |interval: &Interval| (&intervals[interval.position..], false);
            let pairs = Pairs::within(boxes, sink);
            vectorized!(simd => sweep(simd, grain, from, pairs))
        })
    }
}

/// The interval of a block along the axis during the step.
struct Interval {
    lower: f32,
    upper: f32,
    block: usize,
    /// The index among the sorted intervals.
    position: usize,
}

impl Interval {
    fn sorted<const T: usize>(boxes: &Boxes<T>, axis: usize) -> Vec<Self> {
        let interval = |(block, around): (usize, &MovingBox<T>)| {
            let lower = around.lower.iter().map(|point| point[axis]);
            let upper = around.upper.iter().map(|point| point[axis]);
            Self {
                lower: lower.fold(f32::INFINITY, f32::min),
                upper: upper.fold(f32::NEG_INFINITY, f32::max),
                block,
                position: 0,
            }
        };
        let mut intervals: Vec<Self> = boxes.around.par_iter().enumerate().map(interval).collect();
        intervals.par_sort_by(|a, b| a.lower.total_cmp(&b.lower));
        for (position, interval) in intervals.iter_mut().enumerate() {
            interval.position = position;
        }
        intervals
    }
}

/// The axis along which the boxes extend farthest.
fn longest_axis<const T: usize>(boxes: &Boxes<T>) -> usize {
    let around = boxes
        .around
        .iter()
        .fold(MovingBox::EMPTY, |all, around| all.union(around));
    around.places()[0].longest_side()
}

/// Adds the pairs of each block with the blocks whose intervals begin inside its own.
///
/// `later` returns the blocks from which on intervals begin later, and true if these blocks are the
/// first in a pair.
#[inline(always)]
fn sweep<'i, const T: usize, S: Simd>(
    simd: S,
    intervals: &[Interval],
    later: impl Fn(&Interval) -> (&'i [Interval], bool),
    mut pairs: Pairs<'_, T>,
) -> ControlFlow<()> {
    for interval in intervals {
        let (others, first) = later(interval);
        for other in others {
            if other.lower > interval.upper {
                break;
            }
            let [a, b] = if first {
                [other, interval]
            } else {
                [interval, other]
            };
            pairs.add(simd, a.block, b.block)?;
        }
    }
    pairs.flush()
}
