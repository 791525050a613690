//! The last phase: vertices return towards the given positions and the given shape, by certified steps.

use exact_ccd_mesh::vector::minus;
use exact_ccd_mesh::{FreeStepOptions, Point};

use crate::error::RepairError;
use crate::near::near_pairs;
use crate::problem::{Problem, moved};
use crate::progress::Phase;
use crate::shape::Shape;
use crate::slide::slide;

/// The largest number of rounds.
const ROUNDS: usize = 100;

/// The fraction of a free step that is kept.
const KEEP: f64 = 0.7;

/// The displacement in a round at which the return ends, relative to the diagonal.
const STILL: f64 = 1e-5;

/// The distance beyond the minimum distance at which a pair is near, relative to the mean length of edges.
const NEAR: f64 = 0.05;

/// Positions that a free motion reaches from `x`, near the given ones and near their shape. The motion
/// decreases the energy of [`Shape`], and each of its steps is certified to be free of contact. A stop by the
/// caller ends it early.
pub(crate) fn restore(problem: &mut Problem<'_>, mut x: Vec<Point>) -> Result<Vec<Point>, RepairError> {
    let Problem {
        mesh,
        given,
        size,
        options,
        ..
    } = *problem;
    let shape = Shape::new(mesh, &problem.unknowns, given, &size)?;
    let min_distance = options.min_distance;
    let step_options = FreeStepOptions::default()
        .with_keep(KEEP)
        .with_min_distance(min_distance);
    let distance = min_distance.get() + NEAR * size.mean_edge;
    for round in 0..ROUNDS {
        let near = near_pairs(problem, &x, distance)?;
        if problem.ends(Phase::Return, round, near.len()).is_some() {
            break;
        }
        let target = shape.nearer(&problem.unknowns, &x);
        let mut displacements: Vec<Point> = target
            .iter()
            .zip(&x)
            .map(|(&to, &from)| minus(to, from))
            .collect();
        slide(problem, &near, &mut displacements);
        let target = moved(&x, &displacements, 1.0);
        let step = problem
            .detector
            .free_steps(&x, &target, &options.pinned, &step_options)?;
        let parts = x
            .iter()
            .zip(&step.positions)
            .flat_map(|(&from, &to)| minus(to, from));
        let most = parts.fold(0.0_f64, |most, part| most.max(part.abs()));
        x = step.positions;
        if most < STILL * size.diagonal {
            break;
        }
    }
    Ok(x)
}
