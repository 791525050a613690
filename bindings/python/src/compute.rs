//! Computations without the interpreter lock, with progress, which Ctrl-C ends.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

use pyo3::prelude::*;

use crate::pool::pool;

/// The interval between two checks for signals and two calls for progress.
const REPORT_INTERVAL: Duration = Duration::from_millis(100);

/// The state that a computation shares with the thread that waits for it.
#[derive(Debug, Default)]
pub(crate) struct Watch {
    is_cancelled: AtomicBool,
    done: AtomicUsize,
}

impl Watch {
    /// Returns true if the computation is to end: its result is not used.
    pub(crate) fn is_cancelled(&self) -> bool {
        self.is_cancelled.load(Ordering::Relaxed)
    }

    /// Adds to the number of steps that are done.
    pub(crate) fn add(&self, count: usize) {
        self.done.fetch_add(count, Ordering::Relaxed);
    }

    /// Ends the computation.
    pub(crate) fn cancel(&self) {
        self.is_cancelled.store(true, Ordering::Relaxed);
    }

    /// Begins another computation.
    pub(crate) fn reset(&self) {
        self.is_cancelled.store(false, Ordering::Relaxed);
        self.done.store(0, Ordering::Relaxed);
    }

    /// Handles signals, and calls `progress` with the number of steps done since the last call.
    fn report(&self, py: Python<'_>, progress: Option<&Py<PyAny>>) -> PyResult<()> {
        py.check_signals()?;
        if let Some(progress) = progress {
            let done = self.done.swap(0, Ordering::Relaxed);
            if done > 0 {
                progress.call1(py, (done,))?;
            }
        }
        Ok(())
    }
}

/// The result of `work`, which runs on the threads of a pool.
///
/// # Errors
/// The exception of a signal handler, such as `KeyboardInterrupt`, or of `progress`.
pub(crate) fn compute<T: Send>(
    py: Python<'_>,
    threads: Option<usize>,
    progress: Option<&Py<PyAny>>,
    watch: &Watch,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    let pool = pool(threads)?;
    let result = py.detach(|| -> PyResult<Option<T>> {
        let (sender, receiver) = mpsc::sync_channel(1);
        pool.in_place_scope(|scope| {
            scope.spawn(|_| {
                // The receiver is dropped only if the result is not used.
                let _ = sender.send(work());
                drop(sender);
            });
            loop {
                match receiver.recv_timeout(REPORT_INTERVAL) {
                    Ok(result) => return Ok(Some(result)),
                    // A panic, which the end of the scope passes on.
                    Err(RecvTimeoutError::Disconnected) => return Ok(None),
                    Err(RecvTimeoutError::Timeout) => {
                        Python::attach(|py| watch.report(py, progress)).inspect_err(|_| watch.cancel())?;
                    }
                }
            }
        })
    })?;
    watch.report(py, progress)?;
    Ok(result.expect("a panic has been passed on"))
}
