//! Repair for positions in single precision.

use std::sync::Arc;

use exact_ccd_mesh::{Point, Separation, TriangleMesh};

use crate::change::Change;
use crate::error::RepairError;
use crate::options::RepairOptions;
use crate::outcome::{Outcome, Reason, Repaired, Unrepaired};
use crate::problem::Problem;
use crate::repair::repair;

/// The number of repairs, each with a wider distance than the one before.
const TRIES: usize = 6;

/// Moves vertices as [`repair`] does, to positions whose coordinates are all `f32`, except for pinned
/// vertices, which keep their bits.
///
/// The given positions are rounded first, and the counts of pairs before are about the rounded ones. A repair
/// is rounded, and decided again as it is. If a pair is within the minimum distance then, the repair is made
/// again with a wider distance: by four times the largest rounding error, then by eight times, and so on.
/// Each of these repairs has the rounds of the options. After six, the outcome is unrepaired.
///
/// # Errors
/// As of [`repair`], and for a coordinate beyond the range of `f32`.
pub fn repair_in_f32(
    mesh: &Arc<TriangleMesh>,
    positions: &[Point],
    options: &RepairOptions<'_>,
) -> Result<Outcome, RepairError> {
    let mut problem = Problem::new(mesh, positions, options)?;
    let given = rounded(&problem, positions)?;
    let before = problem.found(&given)?;
    let (mut distance, mut factor) = (options.min_distance, 4.0);
    let mut tries = 0;
    loop {
        let attempt = options.clone().with_min_distance(distance);
        let (found, ended) = match repair(mesh, &given, &attempt)? {
            Outcome::Repaired(repaired) => (repaired.positions, None),
            Outcome::Unrepaired(unrepaired) if tries == 0 && unrepaired.reason == Reason::Pinned => {
                return Ok(Outcome::Unrepaired(unrepaired));
            }
            Outcome::Unrepaired(unrepaired) => (unrepaired.positions, Some(unrepaired.reason)),
        };
        // The decision is about the rounded positions and the distance of the options.
        let positions_in_f32 = rounded(&problem, &found)?;
        let (crossings, contacts) = problem.found(&positions_in_f32)?;
        if crossings.is_empty() && contacts.is_empty() {
            return Ok(Outcome::Repaired(Repaired {
                change: Change::new(mesh, &problem.size, positions, &positions_in_f32),
                positions: positions_in_f32,
                crossings: before.0.len(),
                contacts: before.1.len(),
            }));
        }
        let error = largest_difference(&found, &positions_in_f32);
        let wider = Separation::new(options.min_distance.get() + factor * error).ok();
        tries += 1;
        match wider.filter(|_| ended.is_none() && tries < TRIES) {
            Some(wider) => (distance, factor) = (wider, 2.0 * factor),
            None => {
                return Ok(Outcome::Unrepaired(Unrepaired {
                    positions: positions_in_f32,
                    crossings,
                    contacts,
                    reason: match ended {
                        Some(reason) if tries == 1 || matches!(reason, Reason::Stopped(_)) => reason,
                        _ => Reason::Rounding,
                    },
                }));
            }
        }
    }
}

/// The nearest positions in single precision; pinned vertices stay.
fn rounded(problem: &Problem<'_>, positions: &[Point]) -> Result<Vec<Point>, RepairError> {
    let round = |(vertex, x): (usize, &Point)| {
        if problem.unknowns.is_pinned(vertex) {
            return Ok(*x);
        }
        let rounded = x.map(|coordinate| f64::from(coordinate as f32));
        if rounded.iter().all(|coordinate| coordinate.is_finite()) {
            Ok(rounded)
        } else {
            Err(RepairError::NotSingle { vertex })
        }
    };
    positions.iter().enumerate().map(round).collect()
}

/// The largest difference of coordinates.
fn largest_difference(a: &[Point], b: &[Point]) -> f64 {
    let pairs = a.as_flattened().iter().zip(b.as_flattened());
    pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}
