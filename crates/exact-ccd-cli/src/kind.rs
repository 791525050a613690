//! The two kinds of query on the command line.

/// `vf` or `ee`.
#[derive(Clone, Copy, clap::ValueEnum, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Kind {
    // Without documentation: clap would show it as help.
    Vf,
    Ee,
}
