//! Ten published methods of continuous collision detection, and the exact one, behind one trait.
//!
//! Each is implemented from the literature, as published, with its published parameters as the defaults: what it
//! misses and what it invents is part of it. They are here to be compared with; the method to use is [`Exact`].

mod all;
mod bernstein;
mod exact;
mod inclusion;
mod interval;
mod method;
mod parity;
mod root_finding;
mod root_parity;

pub use all::all;
pub use bernstein::{BernsteinSignClassification, TightCcd};
pub use exact::Exact;
pub use inclusion::{IntervalRootFinder, Magnitude, TightInclusion, UnivariateIntervalRootFinder};
pub use method::{Answer, Method, Promise, Time};
pub use parity::RootParity;
pub use root_finding::{FloatingPointRootFinder, MinimumSeparationRootFinder};
pub use root_parity::{BrochuRootParity, RationalRootParity};
