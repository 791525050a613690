//! The commands, each in a file or a folder of its name.

mod audit;
#[cfg(feature = "queries")]
mod bench;
#[cfg(feature = "queries")]
mod convert;
#[cfg(feature = "full")]
mod documents;
#[cfg(feature = "simulate")]
mod import;
#[cfg(feature = "queries")]
mod queries;
#[cfg(feature = "repair")]
mod repair;
#[cfg(feature = "queries")]
mod round;
#[cfg(feature = "simulate")]
mod simulate;
mod step;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::Subcommand;

use crate::messages::failure::Failure;

/// A command with its arguments.
#[derive(Subcommand)]
pub(crate) enum Command {
    Step(step::Arguments),
    Audit(audit::Arguments),
    Merge(audit::MergeArguments),
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

impl Command {
    /// Runs the command. `program` has all commands and options; `line` is the command line.
    #[cfg_attr(
        not(feature = "full"),
        expect(
            unused_variables,
            reason = "only some commands need the program and its command line"
        )
    )]
    pub(crate) fn run(&self, program: fn() -> clap::Command, line: &[OsString]) -> Result<ExitCode, Failure> {
        match self {
            Self::Step(arguments) => step::run(arguments),
            Self::Audit(arguments) => audit::run(arguments),
            Self::Merge(arguments) => audit::merge(arguments),
            #[cfg(feature = "repair")]
            Self::Repair(arguments) => repair::run(arguments),
            #[cfg(feature = "queries")]
            Self::Queries(arguments) => queries::run(arguments),
            #[cfg(feature = "queries")]
            Self::Round(arguments) => round::run(arguments),
            #[cfg(feature = "queries")]
            Self::Convert(arguments) => convert::run(arguments),
            #[cfg(feature = "queries")]
            Self::Bench(arguments) => bench::run(arguments),
            #[cfg(feature = "simulate")]
            Self::Simulate(arguments) => simulate::run(arguments, line),
            #[cfg(feature = "simulate")]
            Self::Import(arguments) => import::run(arguments),
            #[cfg(feature = "full")]
            Self::Completions(arguments) => documents::complete(arguments, program()),
            #[cfg(feature = "full")]
            Self::Man(arguments) => documents::manual(arguments, program()),
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use crate::Program;

    /// A text with lines of its own is not wrapped again on a terminal of 80 columns.
    #[test]
    fn texts_of_several_lines_fit_on_a_terminal() {
        let program = Program::command();
        let mut count = 0;
        for command in program.get_subcommands() {
            let text = command
                .get_long_about()
                .map(ToString::to_string)
                .unwrap_or_default();
            // A paragraph of one line is wrapped by its width.
            for paragraph in text.split("\n\n").filter(|paragraph| paragraph.contains('\n')) {
                for line in paragraph.lines() {
                    assert!(line.chars().count() <= 80, "{}: {line}", command.get_name());
                    count += 1;
                }
            }
        }
        assert!(count > 40, "{count}");
    }
}
