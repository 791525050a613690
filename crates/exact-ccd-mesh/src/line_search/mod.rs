//! Line search: the part of a step that a mesh can go before it touches itself.

mod advance;
mod bisection;
mod error;
mod free_step;
mod free_steps;
mod options;
mod precision;
mod retreat;
mod sizes;
mod watched;

pub use advance::advance;
pub use bisection::{Tolerance, bisect};
pub use error::LineSearchError;
pub use free_step::FreeStep;
pub use free_steps::FreeSteps;
pub use options::FreeStepOptions;
pub use precision::Precision;
