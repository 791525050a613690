//! The `exact-ccd` program as a function: reads files, calls the libraries and reports.
//!
//! The programs `exact-ccd` and `exact-ccd-full` call it.

mod assembly;
mod commands;
mod contacts;
mod files;
mod left_out;
mod messages;
mod motion;
mod options;
#[cfg(feature = "queries")]
mod query_files;
mod text;
mod view;

use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser, value_parser};

use commands::Command;
use messages::failure::Failure;

/// Detect the collisions of moving triangle meshes, exactly: if they touch, and when first.
#[derive(Parser)]
#[command(name = "exact-ccd", version, max_term_width = 100)]
struct Program {
    /// Number of threads [default: number of cores]
    #[arg(long, global = true, value_name = "N", value_parser = value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    #[command(subcommand)]
    command: Command,
}

/// Runs the program with these arguments, in a process of its own. The first one is its name.
///
/// Exit status: 0 for success, 1 for contact, 2 for an error, with one line on standard error, 3 if there is
/// no certificate. The help text and errors in the arguments end the process. Ctrl-C ends a simulation after
/// the last complete time step, with the status 130.
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let matches = left_out::commands(Program::command()).get_matches_from(&arguments);
    let included = left_out::check(&matches);
    let ended = included.and_then(|()| {
        let program = Program::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
        run(&program, &arguments)
    });
    ended.unwrap_or_else(|failure| {
        // An error of standard error itself cannot be reported.
        let _ = writeln!(std::io::stderr(), "exact-ccd: error: {}", failure.on_one_line());
        ExitCode::from(2)
    })
}

/// Runs a command on threads of its own. `line` is the command line.
fn run(program: &Program, line: &[OsString]) -> Result<ExitCode, Failure> {
    // 0 stands for the number of cores.
    let threads = program.threads.unwrap_or(0);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.into())
        .build()
        .map_err(|error| Failure::new(format_args!("cannot start the threads: {error}")))?;
    pool.install(|| program.command.run(Program::command, line))
}
