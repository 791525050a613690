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

/// Moves vertices as [`repair`] does, to positions whose coordinates are all `f32`.
///
/// The given positions are rounded first: change and counts are relative to the rounded ones, and pinned
/// vertices stay there. A repair is rounded, and decided again as it is. If a pair is within the minimum
/// distance then, the repair is made again with a wider distance: by four times the largest rounding error,
/// then by eight times, and so on. After six repairs, the outcome is unrepaired.
///
/// # Errors
/// As of [`repair`].
pub fn repair_in_f32(
    mesh: &Arc<TriangleMesh>,
    positions: &[Point],
    options: &RepairOptions<'_>,
) -> Result<Outcome, RepairError> {
    let given = rounded(positions);
    let (mut distance, mut factor) = (options.min_distance, 4.0);
    let mut before = None;
    let mut tries = 0;
    loop {
        let repaired = match repair(mesh, &given, &options.clone().with_min_distance(distance))? {
            Outcome::Repaired(repaired) => repaired,
            unrepaired @ Outcome::Unrepaired(_) => return Ok(unrepaired),
        };
        let (crossings, contacts) = *before.get_or_insert((repaired.crossings, repaired.contacts));
        let positions = rounded(&repaired.positions);
        let mut problem = Problem::new(mesh, &given, options)?;
        let found = problem.found(&positions)?;
        if found.0.is_empty() && found.1.is_empty() {
            return Ok(Outcome::Repaired(Repaired {
                change: Change::new(mesh, &problem.size, &given, &positions),
                positions,
                crossings,
                contacts,
            }));
        }
        tries += 1;
        let error = largest_difference(&repaired.positions, &positions);
        let wider = Separation::new(options.min_distance.get() + factor * error);
        let Some(wider) = wider.ok().filter(|_| tries < TRIES) else {
            return Ok(Outcome::Unrepaired(Unrepaired {
                positions,
                crossings: found.0,
                contacts: found.1,
                reason: Reason::Rounding,
            }));
        };
        (distance, factor) = (wider, 2.0 * factor);
    }
}

/// The nearest positions in single precision.
fn rounded(positions: &[Point]) -> Vec<Point> {
    let round = |x: &Point| x.map(|coordinate| f64::from(coordinate as f32));
    positions.iter().map(round).collect()
}

/// The largest difference of coordinates.
fn largest_difference(a: &[Point], b: &[Point]) -> f64 {
    let pairs = a.as_flattened().iter().zip(b.as_flattened());
    pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}
