//! Nine published methods of continuous collision detection behind the trait
//! [`Ccd`](exact_ccd::Ccd), for comparison.
//!
//! Each is implemented from the literature, as published and with its published parameters as the
//! defaults. Its false negatives and false positives are part of it, and its documentation lists
//! them. [`all`] adds [`Exact`](exact_ccd::Exact), which is the one to use, and
//! [`RootParity`](parity::RootParity), whose count of contacts is in [`parity`].
//!
//! ```
//! use exact_ccd::{Query, VertexFace};
//!
//! let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
//! let at = |z: f64| [[0.25, 0.25, z], face[0], face[1], face[2]];
//! let query = Query::<VertexFace>::new(at(1.0), at(-1.0))?;
//!
//! let tight_inclusion = exact_ccd_methods::by_name("ti")?;
//! let time = tight_inclusion.time_of_impact(&query);
//! assert!(time.is_some_and(|time| time <= 0.5));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bernstein;
mod inclusion;
mod integers;
mod interval;
pub mod parity;
mod registry;
mod ring;
mod root_finding;
mod vector;

pub use bernstein::{BernsteinSignClassification, TightCcd};
pub use inclusion::{IntervalRootFinder, Magnitude, TightInclusion, UnivariateIntervalRootFinder};
pub use parity::{BrochuRootParity, RationalRootParity};
pub use registry::{UnknownMethod, all, by_name, names};
pub use root_finding::{FloatingPointRootFinder, MinimumSeparationRootFinder};
