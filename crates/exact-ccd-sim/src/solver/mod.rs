//! The minimisation of the incremental potential of one time step, by projected Newton.

mod couplings;
mod direction;
mod dirichlet_steps;
mod form;
mod line_search;
mod linear;
mod newton;
mod pattern;
mod potential;
mod quadratic;
mod stagnation;
#[cfg(test)]
mod tests;
mod unknowns;
mod vertex_search;
mod vertex_steps;

pub(crate) use form::Form;
pub(crate) use newton::{Iterate, Memory, Newton};
pub(crate) use potential::Terms;
