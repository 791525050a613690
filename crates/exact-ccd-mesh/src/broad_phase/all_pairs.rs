//! All pairs of boxes.

use core::ops::ControlFlow;

use fearless_simd::Simd;

use super::boxes::Boxes;
use super::pairs::Pairs;
use super::vectors::vectorized;
use super::{BoxPairs, PairSink};

/// Tests all pairs of boxes: the reference in tests of the other broad phases.
#[derive(Clone, Copy, Debug, Default)]
pub struct AllPairs;

impl<const T: usize> BoxPairs<T> for AllPairs {
    fn between(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        vectorized!(simd => all(simd, a, b, |_| 0, Pairs::between(a, b, sink)))
    }

    fn within(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        vectorized!(simd => all(simd, boxes, boxes, |i| i, Pairs::within(boxes, sink)))
    }
}

#[inline(always)]
fn all<const T: usize, S: Simd>(
    simd: S,
    a: &Boxes<T>,
    b: &Boxes<T>,
    first: impl Fn(usize) -> usize,
    mut pairs: Pairs<'_, T>,
) -> ControlFlow<()> {
    for i in 0..a.blocks.len() {
        for j in first(i)..b.blocks.len() {
            pairs.add(simd, i, j)?;
        }
    }
    pairs.flush()
}
