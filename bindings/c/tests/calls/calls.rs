//! Calls of the C interface with arguments from bytes. No call may have the status of a defect; a call
//! that fails writes nothing and leaves a message; the answers of all functions agree.

mod batches;
mod input;
mod meshes;
mod queries;

use core::ffi::CStr;

use arbitrary::Unstructured;
use exact_ccd_c::{Status, exact_ccd_last_error};

/// Decodes calls from bytes, and checks them. Returns the number of contacts found, at most one by a
/// query and one by a mesh.
pub(crate) fn check(bytes: &[u8]) -> usize {
    let mut bytes = Unstructured::new(bytes);
    // Too few bytes are no call.
    let of_query = queries::check(&mut bytes).unwrap_or_default();
    let _ = batches::check(&mut bytes);
    let of_mesh = meshes::check(&mut bytes).unwrap_or_default();
    usize::from(of_query) + usize::from(of_mesh)
}

/// Returns true if a call has results. A call that fails has a message.
fn succeeds(status: Status) -> bool {
    assert_ne!(status, Status::Internal, "{:?}", message());
    assert!(status == Status::Ok || !message().is_empty(), "{status:?}");
    status == Status::Ok
}

fn message() -> String {
    // SAFETY: the message ends with a zero byte, and no call comes in between.
    unsafe { CStr::from_ptr(exact_ccd_last_error()) }
        .to_string_lossy()
        .into_owned()
}
