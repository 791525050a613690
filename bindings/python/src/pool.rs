//! Threads.

use std::sync::{Arc, Mutex, PoisonError};
use std::{mem, process};

use pyo3::exceptions::PyRuntimeError;
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

/// The pool of this many threads, or of as many as there are cores.
///
/// A thread of a pool that makes a computation, as a rule does, waits for its end. It gets a pool of its
/// own, of one thread: two pools would wait for each other, or one for itself.
///
/// A process that was forked has the pools of its parent, but none of their threads: it gets new ones.
pub(crate) fn pool(threads: Option<usize>) -> PyResult<Arc<ThreadPool>> {
    if rayon::current_thread_index().is_some() {
        return new(1);
    }
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
    let pool = new(threads)?;
    all.pools.push((threads, pool.clone()));
    Ok(pool)
}

fn new(threads: usize) -> PyResult<Arc<ThreadPool>> {
    let builder = ThreadPoolBuilder::new().num_threads(threads);
    let pool = builder
        .thread_name(|index| format!("exact-ccd-{index}"))
        .build()
        .map_err(|error| PyRuntimeError::new_err(format!("cannot start the threads: {error}")))?;
    Ok(Arc::new(pool))
}
