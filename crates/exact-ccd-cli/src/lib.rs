//! The `exact-ccd` program as a function: reads files, calls the libraries and reports.
//!
//! The program itself and the Python package call it.

mod answer_rows;
mod audit;
mod bench;
mod contacts;
mod convert;
mod distances;
mod failure;
mod half_spaces;
mod impact_files;
mod import;
mod inputs;
mod kind;
mod method;
mod min_distance;
mod notes;
mod output;
mod progress;
mod queries;
mod query_files;
mod recognise;
mod round;
mod scene;
mod shortest;
mod simulate;
mod step;
mod tally;
mod timed;
mod view;

use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

use clap::{Parser, Subcommand, value_parser};

use failure::Failure;
pub use scene::{FrameOrder, Missing};

/// Exact continuous collision detection: do moving triangles touch, and when first?
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
    Queries(queries::Arguments),
    Round(round::Arguments),
    Convert(convert::Arguments),
    Bench(bench::Arguments),
    Simulate(simulate::Arguments),
    Import(import::Arguments),
}

/// Runs the program with these arguments, of which the first is its name.
///
/// Exit status: 0 for success, 1 for contact, 2 for an error, with one line on standard error. The help
/// text and errors in the arguments end the process.
///
/// It handles no signals: those belong to the process that calls it.
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    run_program(arguments.into_iter().collect(), false)
}

/// Runs the program as [`main`], in a process of its own: Ctrl-C ends a simulation after the last complete
/// time step, with the status 130.
pub fn main_of_process(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    run_program(arguments.into_iter().collect(), true)
}

fn run_program(arguments: Vec<OsString>, is_process: bool) -> ExitCode {
    let program = Program::parse_from(&arguments);
    let command = is_process.then_some(arguments.as_slice());
    run(&program, command).unwrap_or_else(|failure| {
        // An error of standard error itself cannot be reported.
        let _ = writeln!(std::io::stderr(), "exact-ccd: error: {}", failure.on_one_line());
        ExitCode::from(2)
    })
}

/// Runs a command on threads of its own, which end with it: a process may run several, one after the other
/// or at the same time.
fn run(program: &Program, command: Option<&[OsString]>) -> Result<ExitCode, Failure> {
    // 0 stands for the number of cores.
    let threads = program.threads.unwrap_or(0);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.into())
        .build()?;
    pool.install(|| match &program.command {
        Command::Step(arguments) => step::run(arguments),
        Command::Audit(arguments) => audit::run(arguments),
        Command::Queries(arguments) => queries::run(arguments),
        Command::Round(arguments) => round::run(arguments),
        Command::Convert(arguments) => convert::run(arguments),
        Command::Bench(arguments) => bench::run(arguments),
        Command::Simulate(arguments) => simulate::run(arguments, command),
        Command::Import(arguments) => import::run(arguments),
    })
}
