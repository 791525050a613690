//! The pairs of parts that can collide.

use std::ops::Range;

use exact_ccd_mesh::CanCollide;

use super::part::Part;
use super::rules::{PartPair, Rules};
use super::vertex_set::{VertexSet, named_set};
use crate::messages::failure::Failure;

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
