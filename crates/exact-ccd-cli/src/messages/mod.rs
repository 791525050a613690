//! Messages on standard error: errors, notes about the input, and progress.

pub(crate) mod failure;
pub(crate) mod notes;
pub(crate) mod progress;
