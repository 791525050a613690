//! The time of the narrow phase, when it runs inside the broad phase.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use exact_ccd_mesh::{BoxPairs, Boxes, Bvh, PairSink};

/// The hierarchy, with the time spent in its sinks.
#[derive(Default)]
pub(crate) struct Timed {
    nanoseconds: AtomicU64,
}

impl Timed {
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

impl<const T: usize> BoxPairs<T> for Timed
where
    Bvh: BoxPairs<T>,
{
    fn between(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        Bvh.between(a, b, &timed(&self.nanoseconds, sink))
    }

    fn within(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        Bvh.within(boxes, &timed(&self.nanoseconds, sink))
    }
}
