//! Decisions of candidates by any method.
//!
//! Methods decide pairs of a vertex and a face, and pairs of two edges. A vertex is an edge of length
//! zero to them: so the loose pairs are pairs of edges, with the definition of contact for these.

use exact_ccd::batch::Trajectories;
use exact_ccd::{AnyKind, Ccd, Decide, EdgeEdge, Kind, VertexFace, with_kind};
use rayon::prelude::*;

use crate::mesh::TriangleMesh;
use crate::pairs::{ByKind, PairKind};
use crate::steps::Step;

/// The number of pairs that a thread examines between two checks for the end of the search: methods
/// may be a thousand times slower than the exact one.
const GRAIN: usize = 64;

/// Returns true if any of the pairs is in contact in the step, according to a method.
pub(crate) fn collides(method: &dyn Ccd, pairs: &ByKind<Vec<[u32; 2]>>, step: &Step<'_>) -> bool {
    let trajectories = &trajectories(step);
    let collides = |kind: AnyKind, queries: &[[u32; 4]]| {
        let mut collides = false;
        let mut found = |_| collides = true;
        let outcome = match kind {
            AnyKind::VertexFace => {
                Decide::<VertexFace>::collisions(method, trajectories, queries, &mut found)
            }
            _ => Decide::<EdgeEdge>::collisions(method, trajectories, queries, &mut found),
        };
        // A method that does not accept the queries decides nothing.
        outcome.is_err() || collides
    };
    let any = |(kind, pairs): (AnyKind, &Vec<_>)| {
        let chunks = pairs.par_chunks(GRAIN);
        chunks.any(|pairs| collides(kind, &queries(step.mesh(), kind, pairs)))
    };
    pairs.iter().any(any)
}

/// The earliest time of impact of the pairs in the step, according to a method.
pub(crate) fn time_of_impact(
    method: &dyn Ccd,
    pairs: &ByKind<Vec<[u32; 2]>>,
    step: &Step<'_>,
) -> Option<f64> {
    let trajectories = &trajectories(step);
    let earliest = |kind: AnyKind, queries: &[[u32; 4]]| {
        let mut earliest: Option<f64> = None;
        let mut found = |_, time: f64| {
            let time = if time > 0.0 { time.min(1.0) } else { 0.0 };
            earliest = Some(earliest.map_or(time, |earliest| earliest.min(time)));
        };
        let outcome = match kind {
            AnyKind::VertexFace => {
                Decide::<VertexFace>::times_of_impact(method, trajectories, queries, &mut found)
            }
            _ => Decide::<EdgeEdge>::times_of_impact(method, trajectories, queries, &mut found),
        };
        // A method that does not accept the queries has no later time.
        outcome.map_or(Some(0.0), |()| earliest)
    };
    let of_kind = |(kind, pairs): (AnyKind, &Vec<_>)| {
        let chunks = pairs.par_chunks(GRAIN);
        let times = chunks.filter_map(|pairs| earliest(kind, &queries(step.mesh(), kind, pairs)));
        times.reduce_with(f64::min)
    };
    pairs.iter().filter_map(of_kind).reduce(f64::min)
}

fn trajectories(step: &Step<'_>) -> Trajectories {
    let [x0, x1] = step.positions();
    Trajectories::new(x0, x1).expect("a step has as many positions at both ends, and all are finite")
}

/// The pairs of a kind as queries that methods decide.
fn queries(mesh: &TriangleMesh, kind: AnyKind, pairs: &[[u32; 2]]) -> Vec<[u32; 4]> {
    with_kind!(kind, K => {
        let vertices = pairs.iter().filter_map(|&ids| K::vertices(mesh, ids));
        vertices.filter(K::are_apart).map(|vertices| K::OF_FOUR.map(|i| vertices[i])).collect()
    })
}
