//! The `exact-ccd` program: it reads files, asks the libraries, and reports.
//!
//! Status 0 is success, 1 a step with contact, 2 an error, which is told in one line on standard error.

mod failure;
mod progress;
mod queries;
mod shortest;
mod step;
mod step_report;

use std::io::Write;
use std::num::NonZeroUsize;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use failure::Failure;

/// Exact continuous collision detection.
#[derive(Parser)]
#[command(version, about)]
struct Program {
    /// Threads to use; as many as there are cores if not given.
    #[arg(long, global = true, value_name = "N")]
    threads: Option<NonZeroUsize>,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Step(step::Arguments),
    Queries(queries::Arguments),
}

fn main() -> ExitCode {
    let program = Program::parse();
    run(&program).unwrap_or_else(|failure| {
        // Nobody is left to tell if standard error is closed too.
        let _ = writeln!(std::io::stderr(), "exact-ccd: error: {}", failure.on_one_line());
        ExitCode::from(2)
    })
}

fn run(program: &Program) -> Result<ExitCode, Failure> {
    if let Some(threads) = program.threads {
        rayon::ThreadPoolBuilder::new()
            .num_threads(threads.get())
            .build_global()?;
    }
    match &program.command {
        Command::Step(arguments) => step::run(arguments),
        Command::Queries(arguments) => queries::run(arguments),
    }
}
