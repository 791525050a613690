//! The kinds of query on the command line.

use std::fmt;

/// `vf`, `ee`, `ve` or `vv`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Kind {
    // Without documentation: clap would show it as help.
    Vf,
    Ee,
    Ve,
    Vv,
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Vf => "vf",
            Self::Ee => "ee",
            Self::Ve => "ve",
            Self::Vv => "vv",
        })
    }
}
