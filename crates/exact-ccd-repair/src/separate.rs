//! The second phase: pairs within the minimum distance move apart, by certified steps.

use exact_ccd_mesh::{FreeStepOptions, Point};

use crate::error::RepairError;
use crate::near::near_pairs;
use crate::problem::{Ended, Problem, moved};
use crate::progress::Phase;
use crate::slide::part;

/// The distance to reach, relative to the minimum distance.
const BEYOND: f64 = 1.05;

/// The fraction of a free step that is kept.
const KEEP: f64 = 0.7;

/// The smoothing of the displacements.
const SMOOTHING: f64 = 2.0;

/// Positions without pairs within the minimum distance, from positions without intersections and contact.
pub(crate) fn separate(problem: &mut Problem<'_>, mut x: Vec<Point>) -> Result<Ended, RepairError> {
    let min_distance = problem.options.min_distance;
    let wanted = BEYOND * min_distance.get();
    let smoothing = problem.smoothing(SMOOTHING)?;
    let step_options = FreeStepOptions::default().with_keep(KEEP);
    for round in 0.. {
        if !problem.has_contacts(&x, min_distance)? {
            break;
        }
        let near = near_pairs(problem, &x, wanted)?;
        if let Some(reason) = problem.ends(Phase::Separate, round, near.len()) {
            return Ok(Err((x, reason)));
        }
        let displacements = part(problem, &near, wanted);
        let smooth = problem.unknowns.solve(&smoothing, &displacements, |_| [0.0; 3]);
        let target = moved(&moved(&x, &displacements, 0.5), &smooth, 1.0);
        x = problem
            .detector
            .free_steps(&x, &target, &problem.options.pinned, &step_options)?
            .positions;
    }
    Ok(Ok(x))
}
