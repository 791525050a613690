//! The `exact-ccd` program with all commands, for `cargo full` in a checkout.

use std::process::ExitCode;

fn main() -> ExitCode {
    exact_ccd_cli::main(std::env::args_os())
}
