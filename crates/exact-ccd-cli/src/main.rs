//! The `exact-ccd` program.

use std::process::ExitCode;

fn main() -> ExitCode {
    exact_ccd_cli::main(std::env::args_os())
}
