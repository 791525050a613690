//! The first phase: vertices move until no edge passes through a face, and no pair touches.

use exact_ccd_mesh::vector::minus;
use exact_ccd_mesh::{Point, Separation};

use crate::contour::{Surroundings, contour_gradient};
use crate::error::RepairError;
use crate::offsets::offsets;
use crate::outcome::Reason;
use crate::problem::{Ended, Problem, moved};
use crate::progress::Phase;

/// The smoothing of the gradient. It spreads the displacement of a vertex over about √30 edges around it.
/// Less leaves knots tangled.
const SMOOTHING: f64 = 30.0;

/// The smoothing of the displacement from the given positions. Each round takes the mean of both.
const FAIRING: f64 = 0.5;

/// The largest component of a displacement in a round, relative to the mean length of edges.
const PACE: f64 = 0.25;

/// The first offset, relative to the diagonal: pairs that touch exactly have no direction in which they come
/// apart.
const OFFSET: f64 = 1e-7;

/// The number of rounds without fewer crossings than before at which the phase is given up. Knots that come
/// loose have had up to 80.
const PATIENCE: usize = 400;

/// Positions without intersections and contact.
pub(crate) fn loosen(problem: &mut Problem<'_>) -> Result<Ended, RepairError> {
    let Problem {
        mesh, given, size, ..
    } = *problem;
    let smoothing = problem.smoothing(SMOOTHING)?;
    let fairing = problem.smoothing(FAIRING)?;
    let surroundings = Surroundings::new(mesh);
    let still = |_: u32| [0.0; 3];
    let mut offset = OFFSET * size.diagonal;
    let start = moved(given, &offsets(mesh, &problem.unknowns, given), offset);
    let mut x = start.clone();
    let mut best = (usize::MAX, x.clone());
    let mut best_round = 0;
    for round in 0.. {
        let crossings = problem.crossings(&x)?;
        if crossings.is_empty() && !problem.has_contacts(&x, Separation::default())? {
            break;
        }
        if crossings.len() < best.0 {
            best = (crossings.len(), x.clone());
            best_round = round;
        }
        if let Some(reason) = problem.ends(Phase::Loosen, round, crossings.len()) {
            return Ok(Err((best.1, reason)));
        }
        if round - best_round >= PATIENCE {
            return Ok(Err((best.1, Reason::Stalled)));
        }
        let unknowns = &problem.unknowns;
        if crossings.is_empty() {
            // Primitives merely touch: another offset moves them apart, or into each other.
            offset *= 2.0;
            x = moved(&x, &offsets(mesh, unknowns, &x), offset);
            continue;
        }
        let gradient = unknowns.solve(
            &smoothing,
            &contour_gradient(mesh, &surroundings, &x, &crossings),
            still,
        );
        let most = gradient
            .iter()
            .flatten()
            .fold(f64::MIN_POSITIVE, |most, part| part.abs().max(most));
        x = moved(&x, &gradient, PACE * size.mean_edge / most);
        let displacements: Vec<Point> = x.iter().zip(&start).map(|(&x, &start)| minus(x, start)).collect();
        let faired = unknowns.solve(&fairing, &displacements, still);
        x = moved(&moved(&start, &displacements, 0.5), &faired, 0.5);
    }
    Ok(Ok(x))
}
