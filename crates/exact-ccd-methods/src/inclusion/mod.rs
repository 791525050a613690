//! The methods that never miss: they bisect the domain of F and throw away the parts in which it has no root for certain.

mod bisection;
mod cell;
mod gap;
mod interval_root_finder;
mod tight_inclusion;
mod univariate_interval_root_finder;

pub use interval_root_finder::IntervalRootFinder;
pub use tight_inclusion::{Magnitude, TightInclusion};
pub use univariate_interval_root_finder::UnivariateIntervalRootFinder;
