//! The border: all calls from C pass it.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::environment::Environment;
use crate::error::{Error, Status};

/// Runs the body of a function in the standard floating-point environment. An error leaves its
/// message, and a panic ends here.
#[inline]
pub(crate) fn call(body: impl FnOnce() -> Result<(), Error>) -> Status {
    let environment = Environment::standard();
    let outcome = catch_unwind(AssertUnwindSafe(body));
    drop(environment);
    match outcome {
        Ok(Ok(())) => Status::Ok,
        Ok(Err(error)) => error.record(),
        Err(panic) => internal(&*panic).record(),
    }
}

#[cold]
fn internal(panic: &(dyn Any + Send)) -> Error {
    let message = panic
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| panic.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("no message");
    Error::new(
        Status::Internal,
        format!("defect of exact-ccd, please report it: {message}"),
    )
}
