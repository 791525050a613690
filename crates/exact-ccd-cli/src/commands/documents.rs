//! `exact-ccd completions` and `exact-ccd man`: texts that follow from the command line.

use std::process::ExitCode;

use clap_complete::Shell;
use clap_mangen::Man;

use crate::files::outputs::Output;
use crate::messages::failure::Failure;

/// Print the completions of commands and options for a shell.
///
/// For bash, for example:
/// `exact-ccd completions bash --output ~/.local/share/bash-completion/completions/exact-ccd`.
#[derive(clap::Args)]
pub(crate) struct Completions {
    shell: Shell,
    #[command(flatten)]
    output: Output,
}

/// Print the manual page of the program.
///
/// `exact-ccd man` prints the page of the program, and `exact-ccd man step` the page of a command.
#[derive(clap::Args)]
pub(crate) struct Manual {
    /// The command.
    command: Option<String>,
    #[command(flatten)]
    output: Output,
}

pub(crate) fn complete(arguments: &Completions, mut program: clap::Command) -> Result<ExitCode, Failure> {
    let mut text = Vec::new();
    clap_complete::generate(arguments.shell, &mut program, "exact-ccd", &mut text);
    write(&arguments.output, &text)
}

pub(crate) fn manual(arguments: &Manual, mut program: clap::Command) -> Result<ExitCode, Failure> {
    program.build();
    let program = match &arguments.command {
        None => program,
        Some(name) => program.find_subcommand(name).cloned().ok_or_else(|| {
            Failure::new(format_args!(
                "there is no command {name}; `exact-ccd help` lists all"
            ))
        })?,
    };
    let mut text = Vec::new();
    Man::new(program).render(&mut text)?;
    write(&arguments.output, &text)
}

fn write(output: &Output, text: &[u8]) -> Result<ExitCode, Failure> {
    output.write(&String::from_utf8_lossy(text))?;
    Ok(ExitCode::SUCCESS)
}
