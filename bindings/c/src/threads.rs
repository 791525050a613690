//! The threads of the library: pools of a number of threads, which calls and handles share.
//!
//! A handle keeps the pool of its number of threads. Without a handle, two pools are kept: the pool of the
//! default number, and the pool of the last call. The threads of any other pool end.
//!
//! The threads are created in a call, and inherit its floating-point environment: the standard one where
//! [`Environment`](crate::environment::Environment) can set it.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex, PoisonError, Weak};
use std::{mem, process};

use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::border::call;
use crate::error::{Error, Status};

/// The largest number of threads of a pool.
pub(crate) const MOST: u32 = 1024;

/// Sets the number of threads of the calls, detectors and audits that have none of their own: from 1 to
/// 1024, or 0 for the number of cores, which it is without this call. It holds from the next call on, on
/// all threads of the process.
///
/// The number does not change any answer. The threads are kept until there is another number.
#[unsafe(no_mangle)]
pub extern "C" fn exact_ccd_set_threads(count: u32) -> Status {
    call(|| {
        // Made now, so that this call reports a pool that cannot start.
        check(count)?;
        let before = DEFAULT.swap(count, Ordering::Relaxed);
        pool(count).inspect_err(|_| DEFAULT.store(before, Ordering::Relaxed))?;
        Ok(())
    })
}

/// The number of threads of a handle or a call: 0 is the default of the process, which may change.
#[derive(Debug, Default)]
pub(crate) struct Threads {
    count: u32,
    /// The pool of this number, so that its threads are there for the next call with the handle.
    _kept: Option<Arc<ThreadPool>>,
}

impl Threads {
    pub(crate) fn new(count: u32) -> Result<Self, Error> {
        let kept = if count == 0 { None } else { Some(pool(count)?) };
        Ok(Self { count, _kept: kept })
    }

    /// Runs work on this many threads.
    pub(crate) fn run<T: Send>(&self, work: impl FnOnce() -> Result<T, Error> + Send) -> Result<T, Error> {
        let count = match self.count {
            0 => DEFAULT.load(Ordering::Relaxed),
            own => own,
        };
        pool(count)?.install(work)
    }
}

/// The default of the process; 0 is the number of cores.
static DEFAULT: AtomicU32 = AtomicU32::new(0);

/// The pools of a process.
struct Pools {
    process: u32,
    /// All pools that are in use, by their number of threads.
    pools: Vec<(u32, Weak<ThreadPool>)>,
    /// The last one of the default number, and the last one of another number.
    kept: [Option<Arc<ThreadPool>>; 2],
}

static POOLS: Mutex<Pools> = Mutex::new(Pools {
    process: 0,
    pools: Vec::new(),
    kept: [None, None],
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
        all.pools.clear();
        // Not dropped: that would wait for threads that do not exist.
        mem::forget(mem::take(&mut all.kept));
    }
    let known = all.pools.iter().find(|(threads, _)| *threads == count);
    let pool = match known.and_then(|(_, pool)| pool.upgrade()) {
        Some(pool) => pool,
        None => {
            let pool = ThreadPoolBuilder::new()
                .num_threads(count as usize)
                .thread_name(|index| format!("exact-ccd-{index}"))
                .build()
                .map_err(|error| {
                    Error::argument(format_args!("{count} threads cannot be started: {error}"))
                })?;
            let pool = Arc::new(pool);
            all.pools.retain(|(_, pool)| pool.strong_count() > 0);
            all.pools.push((count, Arc::downgrade(&pool)));
            pool
        }
    };
    let is_other = count != DEFAULT.load(Ordering::Relaxed);
    all.kept[usize::from(is_other)] = Some(pool.clone());
    Ok(pool)
}
