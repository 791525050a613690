//! The last phase: vertices return towards the given positions and the given shape, by certified steps.

use exact_ccd_mesh::vector::minus;
use exact_ccd_mesh::{FreeStepOptions, Point};

use crate::change::Change;
use crate::error::RepairError;
use crate::near::near_pairs;
use crate::problem::{Problem, moved};
use crate::progress::Phase;
use crate::shape::Shape;
use crate::slide::slide;

/// The largest number of rounds.
const ROUNDS: usize = 90;

/// The number of rounds after which positions are compared with the best ones so far.
const COMPARED: usize = 5;

/// The fraction of a free step that is kept.
const KEEP: f64 = 0.7;

/// The fraction of its gap that a near pair keeps.
const KEPT: f64 = 0.5;

/// The displacement in a round at which the return ends, relative to the diagonal.
const STILL: f64 = 1e-5;

/// The distance beyond the minimum distance at which a pair is near, relative to the mean length of edges.
const NEAR: f64 = 0.05;

/// Positions that a free motion reaches from `x`, near the given ones and near their shape. The motion
/// descends the energy of [`Shape`], and each of its steps is certified to be free of contact. It ends after
/// some rounds, or if the vertices are nearly still, or if the caller stops it. Of the positions after every
/// few rounds, the ones with the least [damage](Change::damage) are returned.
pub(crate) fn restore(problem: &mut Problem<'_>, mut x: Vec<Point>) -> Result<Vec<Point>, RepairError> {
    let Problem {
        mesh,
        given,
        size,
        options,
        ..
    } = *problem;
    let shape = Shape::new(mesh, &problem.unknowns, given, &problem.closeness)?;
    let damage = |x: &[Point]| Change::new(mesh, &size, given, x).damage();
    let distance = options.min_distance.get() + NEAR * size.mean_edge;
    let step_options = FreeStepOptions::default()
        .with_keep(KEEP)
        .with_min_distance(options.min_distance);
    let mut best = (f64::INFINITY, x.clone());
    for round in 0..ROUNDS {
        let near = near_pairs(problem, &x, distance)?;
        let is_stopped = problem.ends(Phase::Return, round, near.len()).is_some();
        let mut is_still = false;
        if !is_stopped {
            let mut displacements = differences(&shape.nearer(&problem.unknowns, &x), &x);
            slide(problem, &near, KEPT, &mut displacements);
            let towards = moved(&x, &displacements, 1.0);
            let step = problem
                .detector
                .free_steps(&x, &towards, &options.pinned, &step_options)?;
            let parts = differences(&step.positions, &x);
            let most = parts
                .as_flattened()
                .iter()
                .fold(0.0_f64, |most, part| most.max(part.abs()));
            is_still = most < STILL * size.diagonal;
            x = step.positions;
        }
        let is_last = is_stopped || is_still || round + 1 == ROUNDS;
        if is_last || round % COMPARED == COMPARED - 1 {
            let after = damage(&x);
            if after <= best.0 {
                best = (after, x.clone());
            }
        }
        if is_last {
            break;
        }
    }
    Ok(best.1)
}

/// a − b for each vertex.
fn differences(a: &[Point], b: &[Point]) -> Vec<Point> {
    a.iter().zip(b).map(|(&a, &b)| minus(a, b)).collect()
}
