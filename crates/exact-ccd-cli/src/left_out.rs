//! The commands that a build without the feature `full` leaves out.

use clap::{Arg, ArgMatches};

use crate::messages::failure::Failure;

/// A command, its feature, and the summary in the help.
type Optional = (&'static str, &'static str, &'static str);

const QUERIES: &str = "queries";
const REPAIR: &str = "repair";
const SIMULATE: &str = "simulate";
const FULL: &str = "full";

/// All commands that have a feature.
const OPTIONAL: [Optional; 9] = [
    (
        "repair",
        REPAIR,
        "Move the vertices of a mesh that intersects itself until it does not, and decide exactly that it does not",
    ),
    (
        "queries",
        QUERIES,
        "Decide the queries in files, by the exact method or another one",
    ),
    (
        "round",
        QUERIES,
        "Shift and round queries or meshes, so that differences of coordinates are exact",
    ),
    (
        "convert",
        QUERIES,
        "Convert query files from rows to columns and back, without loss",
    ),
    (
        "bench",
        QUERIES,
        "Compare methods on the queries in a folder: time and wrong answers",
    ),
    (
        "simulate",
        SIMULATE,
        "Simulate a scene: elastic bodies with contact and friction, without intersections",
    ),
    (
        "import",
        SIMULATE,
        "Convert a scene of another program to a scene of `exact-ccd simulate`",
    ),
    (
        "completions",
        FULL,
        "Print the completions of commands and options for a shell",
    ),
    ("man", FULL, "Print the manual page of the program"),
];

/// The commands that this build leaves out.
fn left_out() -> impl Iterator<Item = Optional> {
    let is_in = |feature: &str| match feature {
        QUERIES => cfg!(feature = "queries"),
        REPAIR => cfg!(feature = "repair"),
        SIMULATE => cfg!(feature = "simulate"),
        _ => cfg!(feature = "full"),
    };
    OPTIONAL
        .into_iter()
        .filter(move |(_, feature, _)| !is_in(feature))
}

/// The program with the commands that this build leaves out: they are in the help, and accept all arguments.
pub(crate) fn commands(program: clap::Command) -> clap::Command {
    left_out().fold(program, |program, (name, feature, summary)| {
        let arguments = Arg::new("arguments")
            .num_args(0..)
            .trailing_var_arg(true)
            .allow_hyphen_values(true)
            .hide(true);
        let command = clap::Command::new(name)
            .about(format!("{summary} [not in this build: feature {feature}]"))
            .after_help(message(&format!("`{name}`"), feature, name))
            .disable_help_flag(true)
            .arg(arguments);
        program.subcommand(command)
    })
}

/// Refuses a command that this build leaves out.
pub(crate) fn check(matches: &ArgMatches) -> Result<(), Failure> {
    match left_out().find(|(name, ..)| matches.subcommand_name() == Some(name)) {
        None => Ok(()),
        Some((name, feature, _)) => Err(Failure::new(message(&format!("`{name}`"), feature, name))),
    }
}

/// The message for a part of the program that this build leaves out: its feature, and the command lines that
/// include it.
pub(crate) fn message(part: &str, feature: &str, command: &str) -> String {
    format!(
        "{part} is not in this build, which lacks the feature `{feature}`; \
         in a checkout, `cargo full -- {command} ...` runs the program with all of it, \
         `cargo install --locked --path crates/exact-ccd-cli --features full` installs that"
    )
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;
    use crate::Program;

    /// The tests have all features: each optional command is there, once, with the summary of this list.
    #[test]
    fn the_summaries_are_those_of_the_commands() {
        let program = commands(Program::command());
        for (name, _, summary) in OPTIONAL {
            let mut found = program
                .get_subcommands()
                .filter(|command| command.get_name() == name);
            let about = found.next().and_then(|command| command.get_about());
            assert_eq!(about.map(ToString::to_string).as_deref(), Some(summary), "{name}");
            assert!(found.next().is_none(), "{name}");
        }
        // `step`, `audit` and `merge` have no feature.
        assert_eq!(program.get_subcommands().count(), OPTIONAL.len() + 3);
    }
}
