//! Decisions of candidates by any method.
//!
//! Methods decide pairs of a vertex and a face, and pairs of two edges. A vertex is an edge of length
//! zero to them: so the loose pairs are pairs of edges, with the definition of contact for these.

use exact_ccd::batch::Trajectories;
use exact_ccd::{Ccd, Decide, EdgeEdge, Kind, VertexEdge, VertexFace, VertexVertex};
use rayon::prelude::*;

use crate::mesh::TriangleMesh;
use crate::pairs::{ByKind, PairKind};
use crate::steps::Step;

/// The number of pairs that a thread examines between two checks for the end of the search: methods
/// may be a thousand times slower than the exact one.
const GRAIN: usize = 64;

/// A kind of pairs, as a kind of query that methods decide.
trait Posed: PairKind {
    type Query: Kind;

    fn pose(vertices: Self::Vertices) -> <Self::Query as Kind>::Vertices;
}

impl Posed for VertexFace {
    type Query = Self;

    fn pose(vertices: [u32; 4]) -> [u32; 4] {
        vertices
    }
}

impl Posed for EdgeEdge {
    type Query = Self;

    fn pose(vertices: [u32; 4]) -> [u32; 4] {
        vertices
    }
}

impl Posed for VertexEdge {
    type Query = EdgeEdge;

    fn pose([p, a, b]: [u32; 3]) -> [u32; 4] {
        [p, p, a, b]
    }
}

impl Posed for VertexVertex {
    type Query = EdgeEdge;

    fn pose([p, q]: [u32; 2]) -> [u32; 4] {
        [p, p, q, q]
    }
}

/// Returns true if any of the pairs is in contact in the step, according to a method.
pub(crate) fn collides(method: &dyn Ccd, pairs: &ByKind<Vec<[u32; 2]>>, step: &Step<'_>) -> bool {
    let (mesh, x) = (step.mesh(), &trajectories(step));
    has_collision::<VertexFace, _>(method, mesh, x, &pairs.vertex_face)
        || has_collision::<EdgeEdge, _>(method, mesh, x, &pairs.edge_edge)
        || has_collision::<VertexEdge, _>(method, mesh, x, &pairs.vertex_edge)
        || has_collision::<VertexVertex, _>(method, mesh, x, &pairs.vertex_vertex)
}

/// The earliest time of impact of the pairs in the step, according to a method.
pub(crate) fn time_of_impact(
    method: &dyn Ccd,
    pairs: &ByKind<Vec<[u32; 2]>>,
    step: &Step<'_>,
) -> Option<f64> {
    let (mesh, x) = (step.mesh(), &trajectories(step));
    let times = [
        earliest::<VertexFace, _>(method, mesh, x, &pairs.vertex_face),
        earliest::<EdgeEdge, _>(method, mesh, x, &pairs.edge_edge),
        earliest::<VertexEdge, _>(method, mesh, x, &pairs.vertex_edge),
        earliest::<VertexVertex, _>(method, mesh, x, &pairs.vertex_vertex),
    ];
    times.into_iter().flatten().reduce(f64::min)
}

fn trajectories(step: &Step<'_>) -> Trajectories {
    let [x0, x1] = step.positions();
    Trajectories::new(x0, x1).expect("a step has as many positions at both ends, and all are finite")
}

/// Returns true if a method decides that any of the pairs collides.
fn has_collision<K: Posed, M: Decide<K::Query> + ?Sized>(
    method: &M,
    mesh: &TriangleMesh,
    trajectories: &Trajectories,
    pairs: &[[u32; 2]],
) -> bool {
    pairs.par_chunks(GRAIN).any(|pairs| {
        let mut collides = false;
        let queries = queries::<K>(mesh, pairs);
        let outcome = method.collisions(trajectories, &queries, &mut |_| collides = true);
        // A method that does not accept the queries decides nothing.
        outcome.is_err() || collides
    })
}

/// The earliest time of impact of the pairs according to a method.
fn earliest<K: Posed, M: Decide<K::Query> + ?Sized>(
    method: &M,
    mesh: &TriangleMesh,
    trajectories: &Trajectories,
    pairs: &[[u32; 2]],
) -> Option<f64> {
    let earliest = |pairs: &[[u32; 2]]| {
        let mut earliest: Option<f64> = None;
        let queries = queries::<K>(mesh, pairs);
        let outcome = method.times_of_impact(trajectories, &queries, &mut |_, time| {
            let time = if time > 0.0 { time.min(1.0) } else { 0.0 };
            earliest = Some(earliest.map_or(time, |earliest| earliest.min(time)));
        });
        // A method that does not accept the queries has no later time.
        outcome.map_or(Some(0.0), |()| earliest)
    };
    pairs.par_chunks(GRAIN).filter_map(earliest).reduce_with(f64::min)
}

fn queries<K: Posed>(mesh: &TriangleMesh, pairs: &[[u32; 2]]) -> Vec<<K::Query as Kind>::Vertices> {
    let query = |&ids: &[u32; 2]| K::vertices(mesh, ids).filter(K::are_apart).map(K::pose);
    pairs.iter().filter_map(query).collect()
}
