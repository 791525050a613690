//! The kinds of query on the command line.

use std::fmt;

use clap::ValueEnum;

/// `vf`, `ee`, `ve` or `vv`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kind {
    // Without documentation: clap would show it as help.
    Vf,
    Ee,
    Ve,
    Vv,
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.to_possible_value()
            .map_or(Ok(()), |value| f.write_str(value.get_name()))
    }
}
