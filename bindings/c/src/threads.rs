//! The threads of the library: pools of a number of threads, which calls share.
//!
//! The threads are created in a call, and inherit its floating-point environment, the standard one.

use std::mem;
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::border::call;
use crate::error::{Error, Status};

/// The largest number of threads of a pool.
pub(crate) const MOST: u32 = 1024;

/// Sets the number of threads of the calls, detectors and audits that have none of their own: from 1 to
/// 1024, or 0 for the number of cores, which it is without this call. It holds from the next call on, on
/// all threads of the process.
///
/// The number does not change any answer. Threads are kept for later calls with the same number.
#[unsafe(no_mangle)]
pub extern "C" fn exact_ccd_set_threads(count: u32) -> Status {
    call(|| {
        // Made now, so that the error of a pool that cannot start is that of this call.
        pool(count)?;
        DEFAULT.store(count, Ordering::Relaxed);
        Ok(())
    })
}

/// The number of threads of a handle: 0 is the default of the process, which may change.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Threads(u32);

impl Threads {
    pub(crate) fn new(count: u32) -> Result<Self, Error> {
        check(count)?;
        Ok(Self(count))
    }

    /// Runs work on this many threads.
    pub(crate) fn run<T: Send>(self, work: impl FnOnce() -> Result<T, Error> + Send) -> Result<T, Error> {
        let count = match self.0 {
            0 => DEFAULT.load(Ordering::Relaxed),
            own => own,
        };
        pool(count)?.install(work)
    }
}

/// The default of the process; 0 is the number of cores.
static DEFAULT: AtomicU32 = AtomicU32::new(0);

/// The pools of a process, by their number of threads.
struct Pools {
    process: u32,
    pools: Vec<(u32, Arc<ThreadPool>)>,
}

static POOLS: Mutex<Pools> = Mutex::new(Pools {
    process: 0,
    pools: Vec::new(),
});

fn check(count: u32) -> Result<(), Error> {
    if count > MOST {
        return Err(Error::argument(format_args!(
            "{count} threads, expected at most {MOST}, or 0 for the default"
        )));
    }
    Ok(())
}

/// The pool of this many threads, or of as many as there are cores for 0.
///
/// A process that was forked has the pools of its parent, but none of their threads: it gets new ones.
fn pool(count: u32) -> Result<Arc<ThreadPool>, Error> {
    check(count)?;
    let mut all = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
    if all.process != process::id() {
        all.process = process::id();
        // Not dropped: that would wait for threads that do not exist.
        mem::forget(mem::take(&mut all.pools));
    }
    if let Some((_, pool)) = all.pools.iter().find(|(threads, _)| *threads == count) {
        return Ok(pool.clone());
    }
    let pool = ThreadPoolBuilder::new()
        .num_threads(count as usize)
        .thread_name(|index| format!("exact-ccd-{index}"))
        .build()
        .map_err(|error| Error::argument(format_args!("{count} threads cannot be started: {error}")))?;
    let pool = Arc::new(pool);
    all.pools.push((count, pool.clone()));
    Ok(pool)
}
