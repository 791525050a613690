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

/// The factor of the displacement in a round of the first stages, in which it fades, and its smoothing: they
/// undo what loosening has folded.
const FADING: f64 = 0.95;
const SMOOTHING: f64 = 2.0;

/// The number of stages in which the displacement fades.
const FADING_STAGES: usize = 2;

/// The attractions of [`Shape`] in the stages that follow, in which edges return to their lengths.
const ATTRACTIONS: [f64; 4] = [0.003, 0.0017, 0.001, 0.001];

/// The largest numbers of rounds of a stage: while the displacement fades, and after that.
const ROUNDS: [usize; 2] = [50, 25];

/// The fraction of a free step that is kept.
const KEEP: f64 = 0.7;

/// The fraction of its gap that a near pair keeps.
const KEPT: f64 = 0.5;

/// The displacement in a round at which the return ends, relative to the diagonal.
const STILL: f64 = 1e-5;

/// The distance beyond the minimum distance at which a pair is near, relative to the mean length of edges.
const NEAR: f64 = 0.05;

/// Positions that a free motion reaches from `x`, near the given ones and near their shape. The motion
/// decreases the energy of [`Shape`], and each of its steps is certified to be free of contact. Of the
/// positions after each stage, the ones with the least [damage](Change::damage) are returned. A stop by the
/// caller ends it early.
pub(crate) fn restore(problem: &mut Problem<'_>, mut x: Vec<Point>) -> Result<Vec<Point>, RepairError> {
    let Problem {
        mesh, given, size, ..
    } = *problem;
    let fading = problem.unknowns.smoothing(mesh, SMOOTHING)?;
    let mut shape = Shape::new(mesh, &problem.unknowns, given, &size, ATTRACTIONS[0])?;
    let damage = |x: &[Point]| Change::new(mesh, &size, given, x).damage();
    let mut best = (f64::INFINITY, x.clone());
    let mut round = 0;
    let fades = std::iter::repeat_n((ROUNDS[0], None), FADING_STAGES);
    let follow = ATTRACTIONS.map(|attraction| (ROUNDS[1], Some(attraction)));
    for (rounds, attraction) in fades.chain(follow) {
        if let Some(attraction) = attraction {
            shape.set_attraction(&problem.unknowns, attraction)?;
        }
        let target = |problem: &Problem<'_>, x: &[Point]| {
            if attraction.is_some() {
                return shape.nearer(&problem.unknowns, x);
            }
            let smooth = problem
                .unknowns
                .solve(&fading, &differences(x, given), |_| [0.0; 3]);
            moved(given, &smooth, FADING)
        };
        let ended = stage(problem, &mut x, target, &mut round, rounds)?;
        let after = damage(&x);
        if after <= best.0 {
            best = (after, x.clone());
        }
        if ended == Ends::Stopped {
            break;
        }
    }
    Ok(best.1)
}

#[derive(PartialEq, Eq)]
enum Ends {
    Stopped,
    Still,
}

/// Moves vertices towards a target that depends on their places, by certified steps, until the vertices are
/// nearly still, or there have been enough rounds, or the caller stops it.
fn stage(
    problem: &mut Problem<'_>,
    x: &mut Vec<Point>,
    target: impl Fn(&Problem<'_>, &[Point]) -> Vec<Point>,
    round: &mut usize,
    rounds: usize,
) -> Result<Ends, RepairError> {
    let Problem { size, options, .. } = *problem;
    let min_distance = options.min_distance;
    let distance = min_distance.get() + NEAR * size.mean_edge;
    let step_options = FreeStepOptions::default()
        .with_keep(KEEP)
        .with_min_distance(min_distance);
    for _ in 0..rounds {
        let near = near_pairs(problem, x, distance)?;
        if problem.ends(Phase::Return, *round, near.len()).is_some() {
            return Ok(Ends::Stopped);
        }
        *round += 1;
        let mut displacements = differences(&target(problem, x), x);
        slide(problem, &near, KEPT, &mut displacements);
        let towards = moved(x, &displacements, 1.0);
        let step = problem
            .detector
            .free_steps(x, &towards, &options.pinned, &step_options)?;
        let parts = differences(&step.positions, x);
        let most = parts
            .as_flattened()
            .iter()
            .fold(0.0_f64, |most, part| most.max(part.abs()));
        *x = step.positions;
        if most < STILL * size.diagonal {
            break;
        }
    }
    Ok(Ends::Still)
}

/// a − b for each vertex.
fn differences(a: &[Point], b: &[Point]) -> Vec<Point> {
    a.iter().zip(b).map(|(&a, &b)| minus(a, b)).collect()
}
