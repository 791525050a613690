//! The energies, each a sum of terms, and the forces of loads.

pub(crate) mod anchor;
pub(crate) mod contact;
pub(crate) mod damper;
pub(crate) mod distance;
pub(crate) mod elasticity;
pub(crate) mod friction;
pub(crate) mod load;
mod psd;
pub(crate) mod spring;
pub(crate) mod term;
