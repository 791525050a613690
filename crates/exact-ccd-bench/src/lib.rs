//! Times of tasks, and the figures of many; the cloth of several benchmarks.

pub mod cloth;

use std::hint::black_box;
use std::time::Instant;

/// The number of runs of a task; the fastest one counts.
const ATTEMPTS: usize = 5;

/// The number of items that are timed as a whole.
const LARGE: usize = 400_000;

/// The time of a task in seconds.
pub fn seconds<T>(task: impl FnOnce() -> T) -> f64 {
    let clock = Instant::now();
    black_box(task());
    clock.elapsed().as_secs_f64()
}

/// The time of a task in seconds: the least of some runs.
pub fn fastest<T>(runs: usize, mut task: impl FnMut() -> T) -> f64 {
    let times = (0..runs).map(|_| seconds(&mut task));
    times.fold(f64::INFINITY, f64::min)
}

/// The time of a task in nanoseconds: the least of five runs.
pub fn nanoseconds<T>(task: impl FnMut() -> T) -> f64 {
    1e9 * fastest(ATTEMPTS, task)
}

/// The mean time of an item in nanoseconds, in a task for a number of items.
///
/// A task for few items is repeated until the effects of the clock and the caches are negligible.
pub fn nanoseconds_each<T>(count: usize, task: impl Fn() -> T) -> f64 {
    let repetitions = LARGE.div_ceil(count.max(1));
    // The first pass reads memory that the system may have taken since the last round.
    black_box(task());
    let time = seconds(|| {
        for _ in 0..repetitions {
            black_box(task());
        }
    });
    1e9 * time / (repetitions * count) as f64
}

/// The mean of some values.
#[must_use]
pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The median of some values.
#[must_use]
pub fn median(values: &[f64]) -> f64 {
    quantile(values, 0.5)
}

/// The value that this fraction of the values does not exceed: 0.5 for the median, 1 for the greatest.
#[must_use]
pub fn quantile(values: &[f64], fraction: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().saturating_sub(1) as f64;
    let value = sorted.get((fraction * last).round() as usize);
    value.copied().unwrap_or(f64::NAN)
}
