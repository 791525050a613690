//! Pairs of primitives of two bodies that come near each other.

use exact_ccd::motion::{BodyPair, Chain};
use exact_ccd::{AnyKind, Options, Point};
use rayon::prelude::*;

use super::Bodies;
use super::body::Set;
use super::candidate::Candidate;
use super::error::BodiesError;
use crate::broad_phase::{Aabb, BoxPairs, Boxes, Bvh, PairCollector};

/// The sets of the first and of the second primitive of a kind of pairs.
fn sets(kind: AnyKind) -> [Set; 2] {
    match kind {
        AnyKind::VertexFace => [Set::Vertices, Set::Faces],
        AnyKind::EdgeEdge => [Set::Edges; 2],
        AnyKind::VertexEdge => [Set::LooseVertices, Set::LooseEdges],
        AnyKind::VertexVertex => [Set::LooseVertices; 2],
    }
}

/// The candidates of two bodies, by the boxes of the paths of the smaller one in the coordinates of the other
/// one.
pub(super) fn candidates(
    bodies: &Bodies,
    [a, b]: [usize; 2],
    motions: &[Chain],
    options: Options,
) -> Result<Vec<Candidate>, BodiesError> {
    let size = |index: usize| bodies.0[index].frame.positions.len();
    let [moving, resting] = if size(a) > size(b) { [b, a] } else { [a, b] };
    let pair = |first: usize, second: usize| BodyPair::new(motions[first].clone(), motions[second].clone());
    let forward = pair(moving, resting);
    let [body, other] = [moving, resting].map(|index| &bodies.0[index]);
    let d = options.separation.get();
    let ball = path(&forward, body.center).inflated(body.radius).inflated(d);
    if !ball.overlaps(&other.around) {
        return Ok(Vec::new());
    }
    let backward = pair(resting, moving);
    let positions = body.frame.positions.par_iter();
    let paths: Vec<Aabb> = positions.map(|&point| path(&forward, point)).collect();
    let mut all = Vec::new();
    for &kind in AnyKind::ALL {
        let [first, second] = sets(kind);
        for is_swapped in [false, true] {
            // Of two edges or vertices, the one of the lesser body is first.
            if first == second && is_swapped == (moving < resting) {
                continue;
            }
            let [of_moving, of_resting] = if is_swapped {
                [second, first]
            } else {
                [first, second]
            };
            let moved = body.boxes_of(of_moving, &paths, d, other.center);
            let moved = moved.map_err(|error| BodiesError::TooManyPrimitives { body: moving, error })?;
            let found = meeting(&moved, other.resting(of_resting))
                .into_iter()
                .map(|[i, j]| {
                    let [i, j] = [body.id(of_moving, i), other.id(of_resting, j)];
                    Candidate {
                        kind,
                        sets: [first, second],
                        bodies: if is_swapped {
                            [resting, moving]
                        } else {
                            [moving, resting]
                        },
                        primitives: if is_swapped { [j, i] } else { [i, j] },
                        motions: if is_swapped {
                            backward.clone()
                        } else {
                            forward.clone()
                        },
                    }
                });
            all.extend(found);
        }
    }
    Ok(all)
}

/// The box of the path of a point.
fn path(motions: &BodyPair, point: Point) -> Aabb {
    let [lower, upper] = motions.bounds(point);
    Aabb { lower, upper }
}

/// The pairs of boxes that meet.
fn meeting(a: &Boxes<1>, b: &Boxes<1>) -> Vec<[u32; 2]> {
    if a.is_empty() || b.is_empty() {
        return Vec::new();
    }
    let collector = PairCollector::default();
    let _ = Bvh.between(a, b, &|pairs: &[[u32; 2]]| collector.add(pairs.iter().copied()));
    collector.into_sorted()
}
