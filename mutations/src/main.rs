//! Mutations of a crate: small changes of its source code. A test should notice each.
//!
//! All mutations are compiled into the same test programs, and an environment variable selects one. A run of
//! a mutation therefore costs no compilation, and the programs can run on another machine.

mod make;
mod process;
mod replacements;
mod results;
mod rewrite;
mod run;

use std::error::Error;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::{Parser, Subcommand};

#[derive(Parser)]
#[command(about = "Mutations of a crate, and the tests that notice them")]
struct Arguments {
    /// The crate, a folder in `crates`.
    package: String,
    /// The folder of the programs and the results.
    folder: PathBuf,
    #[command(subcommand)]
    command: Step,
}

#[derive(Subcommand)]
enum Step {
    /// Compile the tests with all mutations.
    Make,
    /// Run the tests with each mutation.
    Run {
        /// The number of mutations that run at a time.
        #[arg(long, default_value_t = 1)]
        threads: usize,
        /// The time of all tests of a mutation in the first round; four times it in each following one.
        #[arg(long, default_value_t = 2.0)]
        seconds: f64,
        /// The time after which no mutation begins.
        #[arg(long, default_value_t = 60.0)]
        minutes: f64,
        /// The seed of the order in which mutations run.
        #[arg(long, default_value_t = 1)]
        seed: u64,
        /// The beginnings of names of files whose mutations run first.
        #[arg(long)]
        first: Vec<String>,
    },
}

fn main() -> Result<(), Box<dyn Error>> {
    let Arguments {
        package,
        folder,
        command,
    } = Arguments::parse();
    match command {
        Step::Make => make::make(&package, &folder),
        Step::Run {
            threads,
            seconds,
            minutes,
            seed,
            first,
        } => {
            let end = Instant::now() + Duration::from_secs_f64(60.0 * minutes);
            run::run(
                &package,
                &folder,
                &run::Limits {
                    threads,
                    seconds,
                    end,
                    seed,
                    first,
                },
            )
        }
    }
}
