//! The broad phase of computations that can be cancelled.

use std::ops::ControlFlow;
use std::sync::Arc;

use exact_ccd_mesh::{BoxPairs, Boxes, Bvh, PairSink};

use crate::compute::Watch;

/// The hierarchy, which ends with the computation.
pub(crate) struct Interruptible {
    pub(crate) watch: Arc<Watch>,
}

impl Interruptible {
    fn unless_cancelled(&self, sink: &PairSink<'_>, pairs: &[[u32; 2]]) -> ControlFlow<()> {
        if self.watch.is_cancelled() {
            return ControlFlow::Break(());
        }
        sink(pairs)
    }
}

impl<const T: usize> BoxPairs<T> for Interruptible
where
    Bvh: BoxPairs<T>,
{
    fn between(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        Bvh.between(a, b, &|pairs| self.unless_cancelled(sink, pairs))
    }

    fn within(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        Bvh.within(boxes, &|pairs| self.unless_cancelled(sink, pairs))
    }
}
