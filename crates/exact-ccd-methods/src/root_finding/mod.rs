//! Methods that find the roots in time of polynomials, in floating-point arithmetic.

mod closest;
mod floating_point;
mod jenkins_traub;
mod minimum_separation;
mod polynomial;
mod vectors;

pub use floating_point::FloatingPointRootFinder;
pub use minimum_separation::MinimumSeparationRootFinder;
