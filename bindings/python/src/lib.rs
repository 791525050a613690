//! The compiled part of the Python package `exact_ccd`: the computations, on the arrays of the caller.
//!
//! The Python part converts arguments and has the documentation. Every computation runs without the
//! interpreter lock.

mod batch;
mod bodies;
mod broad_phase;
mod compute;
mod contacts;
mod detector;
mod distance;
mod error;
mod files;
mod half_spaces;
mod impact;
mod kind;
mod mesh;
mod overlaps;
mod page;
mod pool;
mod positions;
mod queries;
#[cfg(feature = "repair")]
mod repair;
mod search;
mod turns;

use pyo3::prelude::*;

/// The compiled part of the package.
#[pymodule]
mod _native {
    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "the name in Python")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
    #[pymodule_export]
    const KINDS: [(&str, usize); exact_ccd::AnyKind::ALL.len()] = crate::kind::KINDS;
    #[pymodule_export]
    use crate::bodies::Bodies;
    #[pymodule_export]
    use crate::detector::Detector;
    #[pymodule_export]
    use crate::error::{CrossingError, UncertifiedError};
    #[pymodule_export]
    use crate::files::{FrameSequence, Welding, in_order, mesh_format, parse_mesh, read_mesh};
    #[pymodule_export]
    use crate::half_spaces::HalfSpaces;
    #[pymodule_export]
    use crate::mesh::Mesh;
    #[pymodule_export]
    use crate::overlaps::overlaps;
    #[pymodule_export]
    use crate::page::Page;
    #[pymodule_export]
    use crate::queries::{collides, impact, intervals, time_and_count, time_of_impact};
    #[cfg(feature = "repair")]
    #[pymodule_export]
    use crate::repair::{repair, repair_recording};
    #[pymodule_export]
    use crate::turns::turns;
}
