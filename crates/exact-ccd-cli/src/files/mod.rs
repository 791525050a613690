//! The files that a command reads and writes, checked before anything is computed.

pub(crate) mod inputs;
pub(crate) mod outputs;
