//! A progress bar for what takes long.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// How long to wait for the end before showing a bar.
const PATIENCE: Duration = Duration::from_millis(500);

/// A bar on standard error, if that is a terminal, which only appears after a while.
pub(crate) struct Progress {
    total: usize,
    done: AtomicUsize,
    started: Instant,
    bar: OnceLock<ProgressBar>,
}

impl Progress {
    pub(crate) fn new(total: usize) -> Self {
        Self {
            total,
            done: AtomicUsize::new(0),
            started: Instant::now(),
            bar: OnceLock::new(),
        }
    }

    /// Tells that `count` more are done. Any thread may.
    pub(crate) fn add(&self, count: usize) {
        let done = self.done.fetch_add(count, Ordering::Relaxed) + count;
        if self.started.elapsed() > PATIENCE {
            self.bar
                .get_or_init(|| self.start_bar())
                .set_position(done as u64);
        }
    }

    fn start_bar(&self) -> ProgressBar {
        let style = ProgressStyle::with_template("{wide_bar} {human_pos} of {human_len} pairs, {eta} left")
            .expect("the template is well-formed");
        ProgressBar::new(self.total as u64).with_style(style)
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = self.bar.get() {
            bar.finish_and_clear();
        }
    }
}
