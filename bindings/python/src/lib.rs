//! The compiled part of the Python package `exact_ccd`: the computations, on the arrays of the caller.
//!
//! The Python part converts arguments and has the documentation. Every computation runs without the
//! interpreter lock.

mod batch;
mod compute;
mod impact;
mod kind;
mod pool;
#[cfg(feature = "program")]
mod program;
mod queries;

use pyo3::prelude::*;

/// The compiled part of the package.
#[pymodule]
mod _native {
    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "the name in Python")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
    #[cfg(feature = "program")]
    #[pymodule_export]
    use crate::program::main;
    #[pymodule_export]
    use crate::queries::{collides, contact_count, contact_times, impacts, time_of_impact};
}
