//! From blocks that meet to pairs of boxes.

use core::ops::ControlFlow;

use fearless_simd::Simd;

use super::PairSink;
use super::block::LANES;
use super::boxes::Boxes;
use super::members::common;

/// The largest number of pairs in a batch: as many as fit into the nearest cache, with the data of
/// their primitives.
const CAPACITY: usize = 1024;

/// The least bit of each lane's byte.
const EACH_LANE: u64 = 0x0101_0101_0101_0101;

/// The pairs of two boxes of one block, the first one before the second: in the byte of a lane, the bits
/// above its number.
const LATER: u64 = 0x0080_c0e0_f0f8_fcfe;

/// Pairs of boxes that one thread has found, passed on in batches.
pub(super) struct Pairs<'a, const T: usize> {
    a: &'a Boxes<T>,
    b: &'a Boxes<T>,
    /// True if `a` and `b` are the same boxes, and each pair counts once.
    is_within: bool,
    found: Vec<[u32; 2]>,
    sink: &'a PairSink<'a>,
}

impl<'a, const T: usize> Pairs<'a, T> {
    /// Pairs of a box in `a` and a box in `b`.
    pub(super) fn between(a: &'a Boxes<T>, b: &'a Boxes<T>, sink: &'a PairSink<'a>) -> Self {
        Self {
            a,
            b,
            is_within: false,
            found: Vec::with_capacity(CAPACITY),
            sink,
        }
    }

    /// Pairs of two boxes in `boxes`, the smaller index first.
    pub(super) fn within(boxes: &'a Boxes<T>, sink: &'a PairSink<'a>) -> Self {
        Self {
            is_within: true,
            ..Self::between(boxes, boxes, sink)
        }
    }

    /// Adds the pairs of a block of `a` and a block of `b`, except pairs with a common label.
    #[inline(always)]
    pub(super) fn add<S: Simd>(&mut self, simd: S, i: usize, j: usize) -> ControlFlow<()> {
        // Copies of the loop, for the kinds of pairs of a mesh.
        let [of_a, of_b] = [self.a, self.b].map(Boxes::members);
        let mut meeting = match (of_a.label_count(), of_b.label_count()) {
            (1, 1) => self.meeting::<S, 1, 1>(simd, i, j),
            (1, 2) => self.meeting::<S, 1, 2>(simd, i, j),
            (1, 3) => self.meeting::<S, 1, 3>(simd, i, j),
            (2, 2) => self.meeting::<S, 2, 2>(simd, i, j),
            (2, 3) => self.meeting::<S, 2, 3>(simd, i, j),
            _ => self.meeting::<S, 0, 0>(simd, i, j),
        };
        meeting &= EACH_LANE * u64::from(of_b.filled(j));
        if self.is_within && i == j {
            meeting &= LATER;
        }
        let (ids, others) = (&of_a.ids()[LANES * i..], &of_b.ids()[LANES * j..]);
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
            self.flush()?;
        }
        ControlFlow::Continue(())
    }

    /// A bit for each pair of a box in a block of `a` and a box in a block of `b`, box by box of the first,
    /// that meet and have none of the first M and N labels in common.
    #[inline(always)]
    fn meeting<S: Simd, const M: usize, const N: usize>(&self, simd: S, i: usize, j: usize) -> u64 {
        let (block, other) = (&self.a.blocks[i], &self.b.blocks[j]);
        let (of_a, of_b) = (self.a.members(), self.b.members());
        let (labels, others) = (of_a.labels::<M>(i), of_b.labels::<N>(j));
        let mut lanes = block.meeting(simd, &self.b.around[j]) & of_a.filled(i);
        // All 64 bits are computed before any is tested: branches here are hard to predict.
        let mut meeting = 0;
        while lanes != 0 {
            let lane = lanes.trailing_zeros() as usize;
            lanes &= lanes - 1;
            let others = other.meeting(simd, &block.lane(lane)) & !common(simd, others, labels, lane);
            meeting |= u64::from(others) << (LANES * lane);
        }
        meeting
    }

    /// Passes the rest on.
    pub(super) fn flush(&mut self) -> ControlFlow<()> {
        if self.found.is_empty() {
            return ControlFlow::Continue(());
        }
        let flow = (self.sink)(&self.found);
        self.found.clear();
        flow
    }
}
