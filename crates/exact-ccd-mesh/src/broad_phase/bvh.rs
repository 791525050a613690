//! A bounding volume hierarchy.

use core::ops::{ControlFlow, Range};

use fearless_simd::Simd;
use rayon::prelude::*;

use super::block::{Block, LANES};
use super::boxes::Boxes;
use super::moving_box::MovingBox;
use super::pairs::Pairs;
use super::vectors::vectorized;
use super::{BoxPairs, PairSink};

/// A bounding volume hierarchy: a tree of boxes in which each inner node has eight children.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bvh;

/// The number of groups of blocks that a thread searches for in one task.
const GRAIN: usize = 4;

/// The number of parts of the boxes; the first grains come from different parts.
const PLACES: usize = 64;

/// The least number of nodes that a thread makes in one task: they take as much time as a task that fills
/// blocks.
const NODES: usize = 256;

// Two implementations, not one for all T: one would be generic, and compiled again in each crate that passes
// a `Bvh`. The other broad phases are rarely passed.
impl BoxPairs<1> for Bvh {
    fn between(&self, a: &Boxes<1>, b: &Boxes<1>, sink: &PairSink<'_>) -> ControlFlow<()> {
        between(a, b, sink)
    }

    fn within(&self, boxes: &Boxes<1>, sink: &PairSink<'_>) -> ControlFlow<()> {
        within(boxes, sink)
    }
}

impl BoxPairs<2> for Bvh {
    fn between(&self, a: &Boxes<2>, b: &Boxes<2>, sink: &PairSink<'_>) -> ControlFlow<()> {
        between(a, b, sink)
    }

    fn within(&self, boxes: &Boxes<2>, sink: &PairSink<'_>) -> ControlFlow<()> {
        within(boxes, sink)
    }
}

fn between<const T: usize>(a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
    let tree = Tree::new(b);
    grains(a.blocks.len()).try_for_each(|groups| {
        let pairs = Pairs::between(a, b, sink);
        vectorized!(simd => tree.search(simd, a, groups, false, pairs))
    })
}

fn within<const T: usize>(boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
    let tree = Tree::new(boxes);
    grains(boxes.blocks.len()).try_for_each(|groups| {
        let pairs = Pairs::within(boxes, sink);
        vectorized!(simd => tree.search(simd, boxes, groups, true, pairs))
    })
}

/// Grains of groups of blocks. The first ones are spread over all boxes, so that a search for any pair ends
/// early.
fn grains(blocks: usize) -> impl ParallelIterator<Item = Range<usize>> {
    let count = blocks.div_ceil(LANES);
    let grains = count.div_ceil(GRAIN);
    let parts = grains.div_ceil(PLACES);
    let places = grains.div_ceil(parts.max(1));
    let spread = move |i: usize| i % places * parts + i / places;
    (0..places * parts).into_par_iter().map(move |i| {
        let first = GRAIN * spread(i);
        first.min(count)..(first + GRAIN).min(count)
    })
}

/// The capacity of the stack of a descent: there are at most 11 levels, and each has at most eight
/// open siblings.
const STACK: usize = 11 * LANES;

/// The boxes around eight blocks each, the boxes around eight of these each, and so on. The shape
/// of the tree follows from the number of blocks; its quality depends on the order of the boxes.
struct Tree<const T: usize> {
    /// The number of blocks of boxes.
    leaves: usize,
    /// The inner nodes by level, each level made from the one before. The last has one block, or
    /// none if there are no boxes.
    levels: Vec<Vec<Block<T>>>,
}

impl<const T: usize> Tree<T> {
    fn new(boxes: &Boxes<T>) -> Self {
        let mut levels = vec![blocks(&boxes.around)];
        while let Some(level) = levels.last().filter(|level| level.len() > 1) {
            let around: Vec<MovingBox<T>> = level.par_iter().with_min_len(NODES).map(Block::union).collect();
            levels.push(blocks(&around));
        }
        Self {
            leaves: boxes.blocks.len(),
            levels,
        }
    }

    /// Adds all pairs of a box in some groups of `a` and a box in the tree. If `later` is set, only
    /// pairs of a block with itself or with a later block.
    #[inline(always)]
    fn search<S: Simd>(
        &self,
        simd: S,
        a: &Boxes<T>,
        groups: Range<usize>,
        later: bool,
        mut pairs: Pairs<'_, T>,
    ) -> ControlFlow<()> {
        let mut open = [(0, 0); STACK];
        for group in groups {
            self.descend(simd, &Group::new(a, group), later, &mut open, &mut pairs)?;
        }
        pairs.flush()
    }

    #[inline(always)]
    fn descend<S: Simd>(
        &self,
        simd: S,
        group: &Group<T>,
        later: bool,
        open: &mut [(u32, u32); STACK],
        pairs: &mut Pairs<'_, T>,
    ) -> ControlFlow<()> {
        open[0] = (self.levels.len() as u32 - 1, 0);
        let mut count = usize::from(self.leaves > 0);
        while count > 0 {
            count -= 1;
            let (level, index) = (open[count].0 as usize, open[count].1 as usize);
            let node = &self.levels[level][index];
            let mut children = node.meeting(simd, &group.around);
            let below = if level == 0 {
                self.leaves
            } else {
                self.levels[level - 1].len()
            };
            // The number of leaves below a child.
            let span = 1 << (3 * level);
            while children != 0 {
                let lane = children.trailing_zeros() as usize;
                children &= children - 1;
                let child = LANES * index + lane;
                if child >= below || later && (child + 1) * span <= group.first {
                    continue;
                }
                if level > 0 {
                    open[count] = (level as u32 - 1, child as u32);
                    count += 1;
                    continue;
                }
                let last = if later { child } else { usize::MAX };
                let mut blocks = group.blocks.meeting(simd, &node.lane(lane)) & group.until(last);
                while blocks != 0 {
                    pairs.add(simd, group.first + blocks.trailing_zeros() as usize, child)?;
                    blocks &= blocks - 1;
                }
            }
        }
        ControlFlow::Continue(())
    }
}

/// Eight blocks, which descend the tree together until they are compared with single blocks.
struct Group<const T: usize> {
    /// The index of the first block.
    first: usize,
    /// The number of blocks: the last group may have fewer.
    count: usize,
    /// The boxes around the blocks.
    blocks: Block<T>,
    /// The box around all of them.
    around: MovingBox<T>,
}

impl<const T: usize> Group<T> {
    fn new(boxes: &Boxes<T>, group: usize) -> Self {
        let first = LANES * group;
        let eight = &boxes.around[first..boxes.around.len().min(first + LANES)];
        Self {
            first,
            count: eight.len(),
            blocks: Block::of(eight),
            around: eight.iter().fold(MovingBox::EMPTY, |all, one| all.union(one)),
        }
    }

    /// Sets a bit for each block of the group with an index up to `last`.
    #[inline(always)]
    fn until(&self, last: usize) -> u32 {
        (1 << self.count.min((last - self.first).saturating_add(1))) - 1
    }
}

/// The boxes in blocks of eight.
fn blocks<const T: usize>(boxes: &[MovingBox<T>]) -> Vec<Block<T>> {
    boxes
        .par_chunks(LANES)
        .with_min_len(NODES)
        .map(Block::of)
        .collect()
}

#[cfg(test)]
mod tests {
    use rayon::prelude::*;

    use super::{GRAIN, PLACES, grains};
    use crate::broad_phase::block::LANES;

    #[test]
    fn each_group_is_in_one_grain_and_the_first_grains_are_from_everywhere() {
        for count in (0..600).chain([4096, 5000]) {
            let all: Vec<_> = grains(LANES * count).collect();
            let mut groups: Vec<usize> = all.iter().cloned().flatten().collect();
            groups.sort_unstable();
            assert!(groups.into_iter().eq(0..count), "{count}");
            let empty = all.iter().filter(|grain| grain.is_empty()).count();
            assert!(empty * PLACES * GRAIN <= count, "{count}: {empty}");
            if count == 5000 {
                let first: Vec<_> = all[..10].iter().map(|grain| grain.start).collect();
                assert!(first.windows(2).all(|pair| pair[1] - pair[0] == 80), "{first:?}");
            }
        }
    }
}
