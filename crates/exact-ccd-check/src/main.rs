//! The program `exact-ccd-check`.
//!
//! `exact-ccd-check CERTIFICATE FRAMES...` prints the statements that a certificate proves about mesh files.
//! It ends with the status 0 if it proves all of them, 1 if it does not, and 2 if a file cannot be read, or
//! the arguments are wrong. With `--help`, it prints its usage and ends with the status 0.

use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

use exact_ccd_check::check::Proved;
use exact_ccd_check::{Failure, check, ply};

const USAGE: &str = "usage: exact-ccd-check CERTIFICATE START END, or more frames\n";

fn prove(certificate: &PathBuf, frames: &[PathBuf]) -> Result<Proved, Failure> {
    let read = |path: &PathBuf| {
        std::fs::read(path).map_err(|error| Failure::Unreadable(error.to_string()).at(path.display()))
    };
    let frame = |path: &PathBuf| ply::read(&read(path)?).map_err(|failure| failure.at(path.display()));
    check(&read(certificate)?, frames.iter().map(frame))
}

fn main() -> ExitCode {
    // Words of a mesh file may have control characters, by which a terminal shows anything.
    let printable = |reason: &str| reason.replace(char::is_control, "?");
    let paths: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let (status, text) = match &paths[..] {
        [certificate, frames @ ..] if frames.len() > 1 => match prove(certificate, frames) {
            Ok(proved) => (0, format!("proved, in integers:\n{proved}")),
            Err(Failure::Refused(reason)) => (1, format!("refused: {reason}\n")),
            Err(Failure::Unreadable(reason)) => (2, format!("unreadable: {}\n", printable(&reason))),
        },
        [option] if option.as_os_str() == "--help" || option.as_os_str() == "-h" => (0, USAGE.to_owned()),
        _ => (2, USAGE.to_owned()),
    };
    // An error of standard output cannot be reported.
    let _ = std::io::stdout().write_all(text.as_bytes());
    ExitCode::from(status)
}
