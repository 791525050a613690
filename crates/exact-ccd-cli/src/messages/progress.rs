//! Progress bars on a terminal for work that takes long.

use std::convert::Infallible;
use std::fmt;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressState, ProgressStyle};

/// The delay before a bar appears.
const PATIENCE: Duration = Duration::from_millis(500);

/// The interval between two updates.
const REFRESH: Duration = Duration::from_millis(100);

/// A count of things without a known total.
pub(crate) fn count(things: &str) -> ProgressBar {
    ProgressBar::new_spinner().with_style(style(&format!("{{spinner}} {{human_pos}} {things}")))
}

/// A bar for `total` things.
pub(crate) fn bar(total: usize, things: &str) -> ProgressBar {
    let template = format!("{{wide_bar}} {{pos}} of {{len}} {things}{{left}}");
    ProgressBar::new(total as u64).with_style(style(&template).with_key("left", left))
}

/// Writes the rate, and the time left if the rest takes as long as what is done, on average: nothing before
/// the first thing is done.
fn left(state: &ProgressState, text: &mut dyn fmt::Write) {
    if let (done @ 1.., Some(total)) = (state.pos(), state.len()) {
        let rest = total.saturating_sub(done) as f64 / done as f64;
        let rate = done as f64 / state.elapsed().as_secs_f64();
        // A progress bar without this text does not matter.
        let _ = write!(
            text,
            ", {rate:.3} a second, {:#} left",
            HumanDuration(state.elapsed().mul_f64(rest))
        );
    }
}

/// A bar for `total` thousandths of data sets.
#[cfg(feature = "queries")]
pub(crate) fn thousandths(total: u64) -> ProgressBar {
    ProgressBar::new(total).with_style(style("{wide_bar} {percent} %, {eta} left"))
}

/// A spinner for work without countable steps.
pub(crate) fn stage(name: &'static str) -> ProgressBar {
    ProgressBar::new_spinner()
        .with_style(style("{spinner} {msg}"))
        .with_message(name)
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).expect("the templates are well-formed")
}

/// Runs `work` and draws the bar on standard error meanwhile, after a delay, if that is a terminal.
///
/// `work` calls its argument with the number of steps just completed, from any thread.
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
        // Without a thread for it, there is no bar.
        let _ = thread::Builder::new().spawn_scoped(scope, move || draw(&bar, done, &end));
        let result = work(&progress);
        drop(working);
        result
    })
}

/// Redraws the bar at intervals until the sender is dropped.
fn draw(bar: &ProgressBar, done: &AtomicUsize, end: &Receiver<Infallible>) {
    let mut pause = PATIENCE;
    while end.recv_timeout(pause) == Err(RecvTimeoutError::Timeout) {
        bar.set_position(done.load(Ordering::Relaxed) as u64);
        pause = REFRESH;
    }
    bar.finish_and_clear();
}
