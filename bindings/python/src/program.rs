//! The program `exact-ccd`.

use std::ffi::OsString;
use std::process::ExitCode;

use pyo3::prelude::*;

/// Runs the program; its exit status.
#[pyfunction]
pub(crate) fn main(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    let status = py.detach(|| exact_ccd_cli::main(arguments));
    // A status can be compared, but not converted.
    (0..=u8::MAX)
        .find(|&code| ExitCode::from(code) == status)
        .unwrap_or(2)
}
