//! One time step: the minimum of an incremental potential, by projected Newton.

mod line_search;
mod linear;
mod newton;
mod pattern;
mod potential;
mod quadratic;
#[cfg(test)]
mod tests;
mod unknowns;

pub(crate) use linear::LinearSolver;
pub(crate) use newton::{Newton, Outcome};
pub(crate) use potential::{Potential, Spring};
