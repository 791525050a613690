//! The rules of the command line for pairs of parts.

use std::fmt;
use std::str::FromStr;

/// The options `--ignore` and `--only`.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Rules {
    /// The parts A and B do not collide; may be repeated. A part is named as its file is, without
    /// folder and extension, or by NAME=FILE in place of FILE. The named groups of files (OBJ, Gmsh,
    /// `comment part` of PLY) are GROUP or PART/GROUP. A:A leaves out the pairs of a part with itself.
    #[arg(long, value_name = "A:B", conflicts_with = "only")]
    pub(super) ignore: Vec<PartPair>,
    /// Only the parts A and B collide; may be repeated.
    #[arg(long, value_name = "A:B")]
    pub(super) only: Vec<PartPair>,
}

/// Two parts or groups by their names, `A:B` on the command line.
#[derive(Clone, Debug)]
pub(crate) struct PartPair(pub(super) [String; 2]);

impl FromStr for PartPair {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once(':') {
            Some((a, b)) if !a.is_empty() && !b.is_empty() && !b.contains(':') => {
                Ok(Self([a.to_owned(), b.to_owned()]))
            }
            _ => Err("expected two names of parts, A:B".to_owned()),
        }
    }
}

impl fmt::Display for PartPair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self([a, b]) = self;
        write!(f, "{a}:{b}")
    }
}
