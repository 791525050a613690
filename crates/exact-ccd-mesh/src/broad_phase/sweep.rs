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
        let [of_a, of_b] = [a, b].map(|boxes| Extent::sorted(boxes, axis));
        // Of two overlapping extents, one begins inside the other.
        of_a.par_chunks(GRAIN).try_for_each(|grain| {
            let after = |extent: &Extent| of_b.partition_point(|other| other.lower < extent.lower);
            let pairs = Pairs::between(a, b, sink);
            vectorized!(simd => sweep(simd, grain, |i| (&of_b[after(i)..], false), pairs))
        })?;
        of_b.par_chunks(GRAIN).try_for_each(|grain| {
            let after = |extent: &Extent| of_a.partition_point(|other| other.lower <= extent.lower);
            let pairs = Pairs::between(a, b, sink);
            vectorized!(simd => sweep(simd, grain, |i| (&of_a[after(i)..], true), pairs))
        })
    }

    fn within(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        let extents = Extent::sorted(boxes, longest_axis(boxes));
        extents.par_chunks(GRAIN).try_for_each(|grain| {
            let from = |extent: &Extent| (&extents[extent.position..], false);
            let pairs = Pairs::within(boxes, sink);
            vectorized!(simd => sweep(simd, grain, from, pairs))
        })
    }
}

/// The extent of a block along the axis during the step.
struct Extent {
    lower: f32,
    upper: f32,
    block: usize,
    /// The index among the sorted extents.
    position: usize,
}

impl Extent {
    fn sorted<const T: usize>(boxes: &Boxes<T>, axis: usize) -> Vec<Self> {
        let extent = |(block, around): (usize, &MovingBox<T>)| {
            let lower = around.lower.iter().map(|point| point[axis]);
            let upper = around.upper.iter().map(|point| point[axis]);
            Self {
                lower: lower.fold(f32::INFINITY, f32::min),
                upper: upper.fold(f32::NEG_INFINITY, f32::max),
                block,
                position: 0,
            }
        };
        let mut extents: Vec<Self> = boxes.around.par_iter().enumerate().map(extent).collect();
        extents.par_sort_by(|a, b| a.lower.total_cmp(&b.lower));
        for (position, extent) in extents.iter_mut().enumerate() {
            extent.position = position;
        }
        extents
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

/// Adds the pairs of each block with the blocks whose extents begin inside its own.
///
/// `later` returns the blocks from which on extents begin later, and true if these blocks are the
/// first in a pair.
#[inline(always)]
fn sweep<'i, const T: usize, S: Simd>(
    simd: S,
    extents: &[Extent],
    later: impl Fn(&Extent) -> (&'i [Extent], bool),
    mut pairs: Pairs<'_, T>,
) -> ControlFlow<()> {
    for extent in extents {
        let (others, first) = later(extent);
        for other in others {
            if other.lower > extent.upper {
                break;
            }
            let [a, b] = if first { [other, extent] } else { [extent, other] };
            pairs.add(simd, a.block, b.block)?;
        }
    }
    pairs.flush()
}
