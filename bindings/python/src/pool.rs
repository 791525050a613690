//! Threads.

use std::sync::{Arc, Mutex, PoisonError};
use std::{mem, process};

use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// The pools of a process, by their number of threads; 0 is the number of cores.
struct Pools {
    process: u32,
    pools: Vec<(usize, Arc<ThreadPool>)>,
}

static POOLS: Mutex<Pools> = Mutex::new(Pools {
    process: 0,
    pools: Vec::new(),
});

/// The largest number of threads, as in the program.
const MOST: usize = 1024;

/// Checks a number of threads.
pub(crate) fn check(threads: Option<usize>) -> PyResult<()> {
    if threads.is_some_and(|threads| !(1..=MOST).contains(&threads)) {
        return Err(PyValueError::new_err(format!("threads must be from 1 to {MOST}")));
    }
    Ok(())
}

/// The pool of this many threads, or of as many as there are cores.
///
/// A process that was forked has the pools of its parent, but none of their threads: it gets new ones.
pub(crate) fn pool(threads: Option<usize>) -> PyResult<Arc<ThreadPool>> {
    check(threads)?;
    let threads = threads.unwrap_or(0);
    let mut all = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
    if all.process != process::id() {
        all.process = process::id();
        // Not dropped: that would wait for threads that do not exist.
        mem::forget(mem::take(&mut all.pools));
    }
    if let Some((_, pool)) = all.pools.iter().find(|(count, _)| *count == threads) {
        return Ok(pool.clone());
    }
    let pool = ThreadPoolBuilder::new()
        .num_threads(threads)
        .thread_name(|index| format!("exact-ccd-{index}"))
        .build()
        .map_err(|error| PyRuntimeError::new_err(format!("cannot start the threads: {error}")))?;
    let pool = Arc::new(pool);
    all.pools.push((threads, pool.clone()));
    Ok(pool)
}
