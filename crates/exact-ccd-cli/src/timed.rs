//! The time of the narrow phase, when it runs inside the broad phase.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use exact_ccd_mesh::{Boxes, BroadPhase, PairSink};

/// A broad phase that adds up the time spent in its sinks.
pub(crate) struct Timed<B> {
    broad_phase: B,
    nanoseconds: AtomicU64,
}

impl<B> Timed<B> {
    pub(crate) fn new(broad_phase: B) -> Self {
        Self {
            broad_phase,
            nanoseconds: AtomicU64::new(0),
        }
    }

    /// The time spent in sinks since the last call, divided by the number of threads.
    pub(crate) fn take_time_in_sinks(&self) -> Duration {
        Duration::from_nanos(self.nanoseconds.swap(0, Ordering::Relaxed))
            / rayon::current_num_threads().max(1) as u32
    }
}

fn timed(nanoseconds: &AtomicU64, sink: &PairSink<'_>) -> impl Fn(&[[u32; 2]]) -> ControlFlow<()> + Sync {
    move |pairs| {
        let clock = Instant::now();
        let flow = sink(pairs);
        nanoseconds.fetch_add(clock.elapsed().as_nanos() as u64, Ordering::Relaxed);
        flow
    }
}

impl<B: BroadPhase> BroadPhase for Timed<B> {
    fn between<const T: usize>(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        self.broad_phase.between(a, b, &timed(&self.nanoseconds, sink))
    }

    fn within<const T: usize>(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        self.broad_phase.within(boxes, &timed(&self.nanoseconds, sink))
    }
}
