//! The program `exact-ccd-check`.
//!
//! `exact-ccd-check CERTIFICATE FRAMES...` prints the statements that a certificate proves about mesh
//! files, and ends with the status 0 if it proves all of them, 1 if it does not, and 2 if a file cannot
//! be read.

use std::io::Write;
use std::process::ExitCode;

use exact_ccd_check::check::Proved;
use exact_ccd_check::{Failure, check, ply};

fn run() -> Result<Proved, Failure> {
    let mut paths = std::env::args_os().skip(1);
    let usage =
        || Failure::Unreadable("usage: exact-ccd-check CERTIFICATE START END, or more frames".to_owned());
    let read = |path: std::ffi::OsString| {
        let error = |error| Failure::Unreadable(format!("{}: {error}", path.display()));
        std::fs::read(&path).map_err(error)
    };
    let certificate = read(paths.next().ok_or_else(usage)?)?;
    if paths.len() < 2 {
        return Err(usage());
    }
    check(
        &certificate,
        paths.map(|path| {
            let name = path.display().to_string();
            ply::read(&read(path)?).map_err(|failure| Failure::Unreadable(format!("{name}: {failure}")))
        }),
    )
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
