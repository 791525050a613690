//! A bounding volume hierarchy.

use core::ops::{ControlFlow, Range};

use fearless_simd::{Simd, dispatch};
use rayon::prelude::*;

use super::block::{Block, LANES, level};
use super::boxes::Boxes;
use super::moving_box::MovingBox;
use super::pairs::Pairs;
use super::{BroadPhase, Visit};

/// Finds the pairs with a hierarchy of boxes, eight below each.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bvh;

/// How many blocks a thread looks up at a time.
const GRAIN: usize = 32;

impl BroadPhase for Bvh {
    fn between<const T: usize>(&self, a: &Boxes<T>, b: &Boxes<T>, visit: &Visit<'_>) -> ControlFlow<()> {
        let tree = Tree::new(b);
        grains(a).try_for_each(|blocks| {
            let pairs = Pairs::between(a, b, visit);
            dispatch!(level(), simd => tree.look_up(simd, a, blocks, false, pairs))
        })
    }

    fn within<const T: usize>(&self, boxes: &Boxes<T>, visit: &Visit<'_>) -> ControlFlow<()> {
        let tree = Tree::new(boxes);
        grains(boxes).try_for_each(|blocks| {
            let pairs = Pairs::within(boxes, visit);
            dispatch!(level(), simd => tree.look_up(simd, boxes, blocks, true, pairs))
        })
    }
}

fn grains<const T: usize>(boxes: &Boxes<T>) -> impl ParallelIterator<Item = Range<usize>> {
    let count = boxes.blocks.len();
    (0..count.div_ceil(GRAIN))
        .into_par_iter()
        .map(move |grain| GRAIN * grain..(GRAIN * (grain + 1)).min(count))
}

/// How many nodes can be waiting for a look at their children: there are at most 11 levels, each with eight of a kind.
const MOST_OPEN: usize = 11 * LANES;

/// The boxes around eight blocks, the boxes around eight times as many, and so on: the shape of the hierarchy is that of
/// the indices, and it is as good as the order of the boxes is.
struct Tree<const T: usize> {
    /// How many blocks of boxes there are.
    leaves: usize,
    /// Level by level, each from the one before; the last has one block, unless there are no boxes at all.
    levels: Vec<Vec<Block<T>>>,
}

impl<const T: usize> Tree<T> {
    fn new(boxes: &Boxes<T>) -> Self {
        let mut levels = vec![above(&boxes.around)];
        while let Some(level) = levels.last().filter(|level| level.len() > 1) {
            let around: Vec<MovingBox<T>> = level.par_iter().with_min_len(64).map(Block::union).collect();
            levels.push(above(&around));
        }
        Self {
            leaves: boxes.blocks.len(),
            levels,
        }
    }

    /// Adds all pairs of a box in some blocks and one in the tree; if `later`, only those of a block and itself or a later
    /// one.
    #[inline(always)]
    fn look_up<S: Simd>(
        &self,
        simd: S,
        a: &Boxes<T>,
        blocks: Range<usize>,
        later: bool,
        mut pairs: Pairs<'_, T>,
    ) -> ControlFlow<()> {
        let mut open = [(0, 0); MOST_OPEN];
        for block in blocks {
            self.descend(simd, block, &a.around[block], later, &mut open, &mut pairs)?;
        }
        pairs.hand_on()
    }

    #[inline(always)]
    fn descend<S: Simd>(
        &self,
        simd: S,
        block: usize,
        around: &MovingBox<T>,
        later: bool,
        open: &mut [(u32, u32); MOST_OPEN],
        pairs: &mut Pairs<'_, T>,
    ) -> ControlFlow<()> {
        open[0] = (self.levels.len() as u32, 0);
        let mut count = usize::from(self.leaves > 0);
        while count > 0 {
            count -= 1;
            let (level, index) = (open[count].0 as usize, open[count].1 as usize);
            if level == 0 {
                pairs.add(simd, block, index)?;
                continue;
            }
            let mut children = self.levels[level - 1][index].meeting(simd, around);
            let below = if level == 1 {
                self.leaves
            } else {
                self.levels[level - 2].len()
            };
            // The first leaf of a child's successor.
            let span = 1 << (3 * (level - 1));
            while children != 0 {
                let child = LANES * index + children.trailing_zeros() as usize;
                children &= children - 1;
                if child < below && !(later && (child + 1) * span <= block) {
                    open[count] = (level as u32 - 1, child as u32);
                    count += 1;
                }
            }
        }
        ControlFlow::Continue(())
    }
}

/// Boxes, eight to a block.
fn above<const T: usize>(boxes: &[MovingBox<T>]) -> Vec<Block<T>> {
    let block = |eight: &[MovingBox<T>]| {
        let mut block = Block::EMPTY;
        for (lane, moving) in eight.iter().enumerate() {
            block.set(lane, moving);
        }
        block
    };
    boxes.par_chunks(LANES).with_min_len(64).map(block).collect()
}
