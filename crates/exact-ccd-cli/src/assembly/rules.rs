//! The pairs of parts that can collide.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

use exact_ccd_mesh::CanCollide;

use super::part::Part;
use super::vertex_set::{VertexSet, named_set};
use crate::messages::failure::Failure;

/// The options `--ignore` and `--only`.
#[derive(Clone, clap::Args)]
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
pub(crate) struct PartPair([String; 2]);

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

/// The pairs of a scene that can collide: all that the rules allow, except pairs of two obstacles.
///
/// Parts have no vertices in common, but groups may have. `--ignore` leaves out primitives with all vertices
/// in a group; `--only` keeps primitives with any vertex in it. If a rule allows an edge, it allows the faces
/// of the edge, as [`CanCollide::new`] expects.
pub(super) fn can_collide(parts: &[Part], rules: &Rules) -> Result<CanCollide, Failure> {
    let sets = |pairs: &[PartPair]| -> Result<Vec<[VertexSet; 2]>, Failure> {
        let pair = |PartPair([a, b]): &PartPair| Ok([named_set(parts, a)?, named_set(parts, b)?]);
        pairs.iter().map(pair).collect()
    };
    let (only, ignore) = (sets(&rules.only)?, sets(&rules.ignore)?);
    let obstacles = parts.iter().filter(|part| part.is_obstacle);
    let obstacles: Vec<Range<u32>> = obstacles.map(|part| part.vertices.clone()).collect();
    for (pair, sets) in rules.only.iter().zip(&only) {
        let rests = |set: &VertexSet| obstacles.iter().any(|part| set.is_of(part));
        if sets.iter().all(rests) {
            return Err(Failure::new(format_args!(
                "--only {pair}: both are obstacles, which are not compared with each other: name a part that moves"
            )));
        }
    }
    if only.is_empty() && ignore.is_empty() && obstacles.is_empty() {
        return Ok(CanCollide::all());
    }
    let rests = move |primitive: &[u32]| obstacles.iter().any(|part| part.contains(&primitive[0]));
    Ok(CanCollide::new(move |a, b| {
        let is_pair = |[first, second]: &[VertexSet; 2], has: fn(&VertexSet, &[u32]) -> bool| {
            has(first, a) && has(second, b) || has(first, b) && has(second, a)
        };
        (only.is_empty() || only.iter().any(|pair| is_pair(pair, VertexSet::has_any)))
            && !ignore.iter().any(|pair| is_pair(pair, VertexSet::has_all))
            && !(rests(a) && rests(b))
    }))
}
