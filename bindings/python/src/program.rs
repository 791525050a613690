//! The program `exact-ccd`.

use std::ffi::OsString;
use std::process::ExitCode;

use pyo3::prelude::*;

/// Runs the program; its exit status.
#[pyfunction]
pub(crate) fn main(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    let status = py.detach(|| exact_ccd_cli::main(arguments));
    match status {
        ExitCode::SUCCESS => 0,
        status if status == ExitCode::from(1) => 1,
        _ => 2,
    }
}
