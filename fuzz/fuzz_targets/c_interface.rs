//! Calls of the C interface: no defect, no result of a call that fails, answers that agree.

#![no_main]

// The C interface alone has these calls; a crate of their own would be longer than they are.
#[path = "../../bindings/c/tests/calls/calls.rs"]
mod calls;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    calls::check(bytes);
});
