//! The minimisation of the incremental potential of one time step, by projected Newton.

mod form;
mod line_search;
mod linear;
mod newton;
mod pattern;
mod potential;
mod quadratic;
#[cfg(test)]
mod tests;
mod unknowns;

pub(crate) use form::Form;
pub(crate) use linear::LinearSolver;
pub(crate) use newton::{Iterate, Newton};
pub(crate) use potential::Potential;
