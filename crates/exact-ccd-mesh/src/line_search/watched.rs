//! Searches with progress that can be cancelled.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use super::error::LineSearchError;
use super::options::FreeStepOptions;
use crate::pairs::Searched;
use crate::search::{Collect, PairCollision, Relevant};

/// The caller's callbacks during a search.
pub(super) struct Watch<'a> {
    options: &'a FreeStepOptions<'a>,
    is_cancelled: AtomicBool,
}

impl<'a> Watch<'a> {
    pub(super) fn new(options: &'a FreeStepOptions<'a>) -> Self {
        Self {
            options,
            is_cancelled: AtomicBool::new(false),
        }
    }

    /// Returns true if the caller cancels the search now or has cancelled it.
    pub(super) fn is_cancelled(&self) -> bool {
        let is_cancelled =
            self.is_cancelled.load(Ordering::Relaxed) || self.options.cancel.is_some_and(|cancel| cancel());
        if is_cancelled {
            self.is_cancelled.store(true, Ordering::Relaxed);
        }
        is_cancelled
    }
}

/// The collector after a search, unless the caller has cancelled it.
pub(super) fn watched<C>(
    collector: C,
    watch: &Watch<'_>,
    search: impl FnOnce(&Watched<'_, C>),
) -> Result<C, LineSearchError> {
    let watched = Watched { collector, watch };
    search(&watched);
    if watch.is_cancelled() {
        return Err(LineSearchError::Cancelled);
    }
    Ok(watched.collector)
}

/// A collector that reports progress and ends when the search is cancelled.
pub(super) struct Watched<'a, C> {
    collector: C,
    watch: &'a Watch<'a>,
}

impl<C: Collect> Collect for Watched<'_, C> {
    type Batch = C::Batch;

    const PROFITS_FROM_SAMPLE: bool = C::PROFITS_FROM_SAMPLE;

    fn until(&self) -> f64 {
        self.collector.until()
    }

    fn relevant<'a, K: Searched>(&self, pairs: &'a [[u32; 2]]) -> ControlFlow<(), Relevant<'a>> {
        if self.watch.is_cancelled() {
            return ControlFlow::Break(());
        }
        self.collector.relevant::<K>(pairs)
    }

    fn add<K: Searched>(&self, batch: &mut C::Batch, ids: [u32; 2], found: PairCollision<'_, K>) {
        self.collector.add(batch, ids, found);
    }

    fn end<K: Searched>(&self, batch: C::Batch, pair_count: usize) -> ControlFlow<()> {
        self.collector.end::<K>(batch, pair_count)?;
        if let Some(progress) = self.watch.options.progress {
            progress(pair_count);
        }
        ControlFlow::Continue(())
    }

    fn forget_sample<K: Searched>(&self) {
        self.collector.forget_sample::<K>();
    }
}
