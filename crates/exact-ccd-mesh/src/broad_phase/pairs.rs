//! From blocks that meet to pairs of boxes.

use core::ops::ControlFlow;

use fearless_simd::Simd;

use super::Visit;
use super::block::LANES;
use super::boxes::Boxes;

/// How many pairs are handed on at a time, at most: as many as fit into the nearer cache, with what is looked up for them.
const CAPACITY: usize = 1024;

/// Pairs of boxes that one thread has found, handed on from time to time.
pub(super) struct Pairs<'a, const T: usize> {
    a: &'a Boxes<T>,
    b: &'a Boxes<T>,
    /// Whether both are the same boxes, and a pair is wanted only once.
    is_within: bool,
    found: Vec<[u32; 2]>,
    visit: &'a Visit<'a>,
}

impl<'a, const T: usize> Pairs<'a, T> {
    /// Of a box in `a` and one in `b`.
    pub(super) fn between(a: &'a Boxes<T>, b: &'a Boxes<T>, visit: &'a Visit<'a>) -> Self {
        Self {
            a,
            b,
            is_within: false,
            found: Vec::with_capacity(CAPACITY),
            visit,
        }
    }

    /// Of two boxes in `boxes`, the lesser index first. Of two blocks the earlier one has to be asked about the later one.
    pub(super) fn within(boxes: &'a Boxes<T>, visit: &'a Visit<'a>) -> Self {
        Self {
            is_within: true,
            ..Self::between(boxes, boxes, visit)
        }
    }

    /// Adds the pairs of a block of `a` and a block of `b`.
    #[inline(always)]
    pub(super) fn add<S: Simd>(&mut self, simd: S, i: usize, j: usize) -> ControlFlow<()> {
        let (block, other) = (&self.a.blocks[i], &self.b.blocks[j]);
        let filled = u64::from(self.b.filled(j));
        let mut lanes = block.meeting(simd, &self.b.around[j]) & self.a.filled(i);
        // All 64 bits before a look at any: few branches, for these are hard to predict.
        let mut meeting = 0;
        while lanes != 0 {
            let lane = lanes.trailing_zeros() as usize;
            lanes &= lanes - 1;
            let later = if self.is_within && i == j { !1 << lane } else { !0 };
            let others = u64::from(other.meeting(simd, &block.lane(lane)));
            meeting |= (others & filled & later) << (LANES * lane);
        }
        let (ids, others) = (&self.a.ids[LANES * i..], &self.b.ids[LANES * j..]);
        while meeting != 0 {
            let bit = meeting.trailing_zeros() as usize;
            meeting &= meeting - 1;
            let (id, other) = (ids[bit / LANES], others[bit % LANES]);
            self.found.push(if self.is_within && other < id {
                [other, id]
            } else {
                [id, other]
            });
        }
        if self.found.len() + LANES * LANES > CAPACITY {
            self.hand_on()?;
        }
        ControlFlow::Continue(())
    }

    /// Hands on what is left.
    pub(super) fn hand_on(&mut self) -> ControlFlow<()> {
        if self.found.is_empty() {
            return ControlFlow::Continue(());
        }
        let flow = (self.visit)(&self.found);
        self.found.clear();
        flow
    }
}
