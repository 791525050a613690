//! The threads of the library. They are created in a call, and inherit its floating-point environment, the
//! standard one.

use crate::border::call;
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
            .build_global()
            .map_err(|error| Error::argument(format_args!("the threads cannot be set: {error}")))
    })
}
