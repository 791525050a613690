//! How far the work is, on a terminal, when it takes long.

use std::convert::Infallible;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// How long to wait for the end before showing anything.
const PATIENCE: Duration = Duration::from_millis(500);

/// The time between two pictures.
const REFRESH: Duration = Duration::from_millis(100);

/// A count of pairs, nobody knows up to how many.
pub(crate) fn pairs() -> ProgressBar {
    ProgressBar::new_spinner().with_style(style("{spinner} {human_pos} pairs"))
}

/// A bar that is full after `total` frames.
pub(crate) fn frames(total: usize) -> ProgressBar {
    ProgressBar::new(total as u64).with_style(style("{wide_bar} {pos} of {len} frames, {eta} left"))
}

/// A bar that is full after `total` time steps.
pub(crate) fn time_steps(total: usize) -> ProgressBar {
    ProgressBar::new(total as u64).with_style(style("{wide_bar} {pos} of {len} time steps, {eta} left"))
}

/// A count of queries, nobody knows up to how many.
pub(crate) fn queries() -> ProgressBar {
    ProgressBar::new_spinner().with_style(style("{spinner} {human_pos} queries"))
}

/// A bar that is full when this many thousandths of data sets are done.
pub(crate) fn thousandths(total: u64) -> ProgressBar {
    ProgressBar::new(total).with_style(style("{wide_bar} {percent} %, {eta} left"))
}

/// Work whose steps cannot be counted.
pub(crate) fn stage(name: &'static str) -> ProgressBar {
    ProgressBar::new_spinner()
        .with_style(style("{spinner} {msg}"))
        .with_message(name)
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).expect("the templates are well-formed")
}

/// Does the work, which tells how many more of its steps are done, from any thread.
///
/// Meanwhile, after a while, the bar is on standard error, if that is a terminal.
pub(crate) fn during<T>(bar: ProgressBar, work: impl FnOnce(&(dyn Fn(usize) + Sync)) -> T) -> T {
    let done = &AtomicUsize::new(0);
    let progress = |count| {
        done.fetch_add(count, Ordering::Relaxed);
    };
    if bar.is_hidden() {
        return work(&progress);
    }
    let (working, end) = mpsc::channel();
    thread::scope(|scope| {
        // If there is no thread to be had, there is no bar.
        let _ = thread::Builder::new().spawn_scoped(scope, move || draw(&bar, done, &end));
        let result = work(&progress);
        drop(working);
        result
    })
}

/// Draws the bar from time to time until the sender is gone.
fn draw(bar: &ProgressBar, done: &AtomicUsize, end: &Receiver<Infallible>) {
    let mut pause = PATIENCE;
    while end.recv_timeout(pause) == Err(RecvTimeoutError::Timeout) {
        bar.set_position(done.load(Ordering::Relaxed) as u64);
        pause = REFRESH;
    }
    bar.finish_and_clear();
}
