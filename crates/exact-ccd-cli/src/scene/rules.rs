//! The pairs of parts that can collide.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

use exact_ccd_mesh::CanCollide;

use super::options::SceneOptions;
use super::part::Part;
use super::vertex_set::{VertexSet, named_set};
use crate::failure::Failure;

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

/// The pairs of a scene that can collide: those of the rules, without those of two obstacles.
///
/// Parts have no vertices in common, but groups may have. `--ignore` leaves out primitives all of whose
/// vertices are in a group; `--only` keeps those with any vertex in it. Both rules allow the faces of an edge
/// that they allow, as [`CanCollide::new`] expects.
pub(super) fn can_collide(parts: &[Part], options: &SceneOptions) -> Result<CanCollide, Failure> {
    let sets = |pairs: &[PartPair]| -> Result<Vec<[VertexSet; 2]>, Failure> {
        let pair = |PartPair([a, b]): &PartPair| Ok([named_set(parts, a)?, named_set(parts, b)?]);
        pairs.iter().map(pair).collect()
    };
    let (only, ignore) = (sets(&options.only)?, sets(&options.ignore)?);
    let obstacles = parts.iter().filter(|part| part.is_obstacle);
    let obstacles: Vec<Range<u32>> = obstacles.map(|part| part.vertices.clone()).collect();
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
