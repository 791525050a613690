//! The `exact-ccd` program as a function: reads files, calls the libraries and reports.
//!
//! The program itself and the Python package call it.

mod audit;
#[cfg(feature = "queries")]
mod bench;
mod certificate;
mod contacts;
#[cfg(feature = "queries")]
mod convert;
#[cfg(feature = "simulate")]
mod curves;
mod distances;
#[cfg(feature = "full")]
mod documents;
mod failure;
mod half_spaces;
mod impact_files;
#[cfg(feature = "simulate")]
mod import;
mod inputs;
mod json;
mod left_out;
mod mesh_arguments;
mod notes;
mod output;
mod progress;
#[cfg(feature = "queries")]
mod queries;
#[cfg(feature = "repair")]
mod repair;
mod report;
#[cfg(feature = "queries")]
mod round;
mod scene;
mod seconds;
mod shortest;
#[cfg(feature = "simulate")]
mod simulate;
mod step;
mod timed;
mod view;

use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand, value_parser};

use failure::Failure;

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

#[derive(Subcommand)]
enum Command {
    Step(step::Arguments),
    Audit(audit::Arguments),
    #[cfg(feature = "repair")]
    Repair(repair::Arguments),
    #[cfg(feature = "queries")]
    Queries(queries::Arguments),
    #[cfg(feature = "queries")]
    Round(round::Arguments),
    #[cfg(feature = "queries")]
    Convert(convert::Arguments),
    #[cfg(feature = "queries")]
    Bench(bench::Arguments),
    #[cfg(feature = "simulate")]
    Simulate(simulate::Arguments),
    #[cfg(feature = "simulate")]
    Import(import::Arguments),
    #[cfg(feature = "full")]
    Completions(documents::Completions),
    #[cfg(feature = "full")]
    Man(documents::Manual),
}

/// Runs the program with these arguments. The first one is its name.
///
/// Exit status: 0 for success, 1 for contact, 2 for an error, with one line on standard error, 3 if there is
/// no certificate. The help text and errors in the arguments end the process.
///
/// It handles no signals, because they belong to the process that calls it.
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    run_program(arguments.into_iter().collect(), false)
}

/// Runs the program as [`main`], in a process of its own: Ctrl-C ends a simulation after the last complete
/// time step, with the status 130.
pub fn main_of_process(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    run_program(arguments.into_iter().collect(), true)
}

fn run_program(arguments: Vec<OsString>, is_process: bool) -> ExitCode {
    let command = is_process.then_some(arguments.as_slice());
    let matches = left_out::commands(Program::command()).get_matches_from(&arguments);
    let included = left_out::check(&matches);
    let ended = included.and_then(|()| {
        let program = Program::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
        run(&program, command)
    });
    ended.unwrap_or_else(|failure| {
        // An error of standard error itself cannot be reported.
        let _ = writeln!(std::io::stderr(), "exact-ccd: error: {}", failure.on_one_line());
        ExitCode::from(2)
    })
}

/// Runs a command on threads of its own, which end with it: a process may run several, one after the other
/// or at the same time.
#[cfg_attr(
    not(feature = "simulate"),
    expect(unused_variables, reason = "only a simulation continues")
)]
fn run(program: &Program, command: Option<&[OsString]>) -> Result<ExitCode, Failure> {
    // 0 stands for the number of cores.
    let threads = program.threads.unwrap_or(0);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.into())
        .build()
        .map_err(|error| Failure::new(format_args!("cannot start the threads: {error}")))?;
    pool.install(|| match &program.command {
        Command::Step(arguments) => step::run(arguments),
        Command::Audit(arguments) => audit::run(arguments),
        #[cfg(feature = "repair")]
        Command::Repair(arguments) => repair::run(arguments),
        #[cfg(feature = "queries")]
        Command::Queries(arguments) => queries::run(arguments),
        #[cfg(feature = "queries")]
        Command::Round(arguments) => round::run(arguments),
        #[cfg(feature = "queries")]
        Command::Convert(arguments) => convert::run(arguments),
        #[cfg(feature = "queries")]
        Command::Bench(arguments) => bench::run(arguments),
        #[cfg(feature = "simulate")]
        Command::Simulate(arguments) => simulate::run(arguments, command),
        #[cfg(feature = "simulate")]
        Command::Import(arguments) => import::run(arguments),
        #[cfg(feature = "full")]
        Command::Completions(arguments) => documents::complete(arguments, Program::command()),
        #[cfg(feature = "full")]
        Command::Man(arguments) => documents::manual(arguments, Program::command()),
    })
}
