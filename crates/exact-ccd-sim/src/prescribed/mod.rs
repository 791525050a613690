//! The motions that scripts prescribe in one part of a time step.

mod dirichlet;
mod held_chains;
mod paths;
mod times;

pub(crate) use dirichlet::Dirichlet;
pub(crate) use held_chains::HeldChains;
pub(crate) use paths::Paths;
pub(crate) use times::Times;
