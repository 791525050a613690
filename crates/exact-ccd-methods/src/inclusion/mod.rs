//! Methods without false negatives: they bisect the domain of F and drop the parts in which it
//! certainly has no root.

mod bisection;
mod cell;
mod gap;
mod interval_root_finder;
mod tight_inclusion;
mod univariate_interval_root_finder;

pub use interval_root_finder::IntervalRootFinder;
pub use tight_inclusion::{Magnitude, TightInclusion};
pub use univariate_interval_root_finder::UnivariateIntervalRootFinder;
