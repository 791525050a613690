//! Searches with progress that can be cancelled.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::mesh::TriangleMesh;
use crate::pairs::PairKind;
use crate::search::{Collect, NarrowPhase};

/// The caller's callbacks during a search.
pub(super) struct Watch<'a> {
    progress: Option<&'a (dyn Fn(usize) + Sync)>,
    cancel: Option<&'a (dyn Fn() -> bool + Sync)>,
    is_cancelled: AtomicBool,
}

impl<'a> Watch<'a> {
    pub(super) fn new(
        progress: Option<&'a (dyn Fn(usize) + Sync)>,
        cancel: Option<&'a (dyn Fn() -> bool + Sync)>,
    ) -> Self {
        Self {
            progress,
            cancel,
            is_cancelled: AtomicBool::new(false),
        }
    }

    /// Returns true if the caller cancels the search now or has cancelled it.
    pub(super) fn is_cancelled(&self) -> bool {
        let is_cancelled =
            self.is_cancelled.load(Ordering::Relaxed) || self.cancel.is_some_and(|cancel| cancel());
        if is_cancelled {
            self.is_cancelled.store(true, Ordering::Relaxed);
        }
        is_cancelled
    }
}

/// A collector that reports progress and ends when the search is cancelled.
pub(super) struct Watched<'a, C> {
    pub(super) collector: C,
    pub(super) watch: &'a Watch<'a>,
}

impl<C: Collect> Collect for Watched<'_, C> {
    const PROFITS_FROM_SAMPLE: bool = C::PROFITS_FROM_SAMPLE;

    fn until(&self) -> f64 {
        self.collector.until()
    }

    fn examine<K: PairKind>(
        &self,
        narrow_phase: &NarrowPhase,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
    ) -> ControlFlow<()> {
        if self.watch.is_cancelled() {
            return ControlFlow::Break(());
        }
        self.collector.examine::<K>(narrow_phase, mesh, pairs)?;
        if let Some(progress) = self.watch.progress {
            progress(pairs.len());
        }
        ControlFlow::Continue(())
    }
}
