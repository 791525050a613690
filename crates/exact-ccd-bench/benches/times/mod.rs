//! Times of single tasks, and the figures of many.

use std::hint::black_box;
use std::time::Instant;

const ATTEMPTS: usize = 5;

/// The time of a task in nanoseconds: the least of some attempts.
pub(crate) fn nanoseconds<T>(task: impl Fn() -> T) -> f64 {
    let attempt = |_| {
        let clock = Instant::now();
        black_box(task());
        clock.elapsed().as_secs_f64() * 1e9
    };
    (0..ATTEMPTS).map(attempt).fold(f64::INFINITY, f64::min)
}

pub(crate) fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The value that this fraction of the values does not exceed: 0.5 for the median, 1 for the greatest.
pub(crate) fn quantile(values: &[f64], fraction: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().saturating_sub(1) as f64;
    let value = sorted.get((fraction * last).round() as usize);
    value.copied().unwrap_or(f64::NAN)
}
