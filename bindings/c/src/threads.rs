//! The threads of the library.

use crate::border::call;
use crate::environment::Environment;
use crate::error::{Error, Status};

/// Sets the number of threads of the library, 0 for the number of cores. To be called before any
/// function of a batch or a detector; without it, the threads are as many as the cores.
///
/// The number does not change any answer.
#[unsafe(no_mangle)]
pub extern "C" fn exact_ccd_set_threads(count: u32) -> Status {
    call(|| {
        rayon::ThreadPoolBuilder::new()
            .num_threads(count as usize)
            .thread_name(|index| format!("exact-ccd-{index}"))
            // A thread inherits the environment of its creator, which may be the host's.
            .start_handler(|_| std::mem::forget(Environment::standard()))
            .build_global()
            .map_err(|error| Error::argument(format_args!("the threads cannot be set: {error}")))
    })
}
