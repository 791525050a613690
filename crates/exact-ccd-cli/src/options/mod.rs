//! Options that several commands have.

pub(crate) mod certificate;
pub(crate) mod distances;
#[cfg(feature = "queries")]
pub(crate) mod kind;
