//! The program `exact-ccd-check`.
//!
//! `exact-ccd-check CERTIFICATE FRAMES...` prints the statements that a certificate proves about mesh
//! files, and ends with the status 0 if it proves all of them, 1 if it does not, and 2 if a file cannot
//! be read.

use std::fmt::Display;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

use exact_ccd_check::check::Proved;
use exact_ccd_check::{Failure, check, ply};

fn run() -> Result<Proved, Failure> {
    let paths: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [certificate, frames @ ..] = &paths[..] else { return usage() };
    if frames.len() < 2 {
        return usage();
    }
    let of =
        |path: &PathBuf, error: &dyn Display| Failure::Unreadable(format!("{}: {error}", path.display()));
    let read = |path: &PathBuf| std::fs::read(path).map_err(|error| of(path, &error));
    let frames = frames.iter().map(|path| ply::read(&read(path)?).map_err(|failure| of(path, &failure)));
    check(&read(certificate)?, frames)
}

fn usage<T>() -> Result<T, Failure> {
    Err(Failure::Unreadable("usage: exact-ccd-check CERTIFICATE START END, or more frames".to_owned()))
}

fn main() -> ExitCode {
    let (status, text) = match run() {
        Ok(proved) => (0, format!("proved, in integers:\n{proved}")),
        Err(Failure::Refused(reason)) => (1, format!("refused: {reason}\n")),
        Err(Failure::Unreadable(reason)) => (2, format!("unreadable: {reason}\n")),
    };
    // An error of standard output cannot be reported.
    let _ = std::io::stdout().write_all(text.as_bytes());
    ExitCode::from(status)
}
