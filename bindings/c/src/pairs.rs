//! Lists of pairs.

use crate::border::call;
use crate::error::Status;
use crate::pair::Pair;
use crate::pointers::{Out, reference};

/// Pairs of primitives, sorted by kind, then by the first index, then by the second.
pub struct Pairs(pub(crate) Vec<Pair>);

/// The number of pairs, and a pointer to the first, which is valid until the list is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_pairs_data(
    pairs: *const Pairs,
    data: *mut *const Pair,
    count: *mut usize,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (Pairs(pairs), data, count) = unsafe {
            let pairs = reference("pairs", pairs)?;
            let data = Out::new("data", data)?;
            (pairs, data, Out::new("count", count)?)
        };
        data.write(pairs.as_ptr());
        count.write(pairs.len());
        Ok(())
    })
}

/// Frees a list of pairs. Null is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_pairs_free(pairs: *mut Pairs) {
    if !pairs.is_null() {
        // SAFETY: made by `exact_ccd_detector_free_steps`, and freed once: the caller's promise.
        drop(unsafe { Box::from_raw(pairs) });
    }
}
