//! The largest free step along a direction.

use exact_ccd::{Ccd, Point};

use super::advance::advance;
use super::bisection::{Tolerance, bisect};
use super::error::LineSearchError;
use super::options::FreeStepOptions;
use crate::broad_phase::Bvh;
use crate::mesh::{TriangleMesh, check_positions};
use crate::search::{Candidates, Detector};
use crate::steps::Step;

/// The algorithm of [`step_size`].
#[derive(Clone, Copy)]
pub enum LineSearch<'a> {
    /// From the exact time of impact of the full step.
    Exact,
    /// By bisection, see [`bisect`].
    Bisection {
        /// The width of the interval at which to stop.
        tolerance: Tolerance,
        /// The method that decides if a step is free of contact.
        method: &'a dyn Ccd,
    },
}

/// The largest step along a direction: the positions `start` + α `direction`, rounded, can be
/// reached from `start` without contact.
///
/// The result is in [0, 1]; 1 if the full step is free, 0 if the mesh touches itself at the start.
/// Unless it is 0, with [`LineSearch::Exact`], and with the method [`Exact`](exact_ccd::Exact), the
/// step from `start` to [`advance`]`(start, direction, α)` has been checked to be free of contact,
/// exactly, for the rounded positions.
///
/// With [`LineSearch::Exact`], α is the time of impact of the full step, or the first, second,
/// fourth, … f64 below it: the first of these for which the step is free. It is the size
/// of [`Detector::free_step_along`](crate::Detector::free_step_along) with `keep` = 1. A
/// bisection returns a step that is smaller by up to its tolerance. A larger step may be free, too: its
/// rounded positions are others.
///
/// A mesh that is pierced at the start, by an edge that passes through a face, may be free of contact, and
/// the size is 1: [`intersections`](crate::intersections) finds such edges, and
/// [`Detector::with_start_check`](crate::Detector::with_start_check) begins every search with that test.
///
/// # Errors
/// [`LineSearchError`] names the positions or parts of the direction that are too many, too few or
/// not finite.
///
/// ```
/// use exact_ccd_mesh::{LineSearch, TriangleMesh, step_size};
///
/// let mesh = TriangleMesh::new(4, vec![[0, 1, 2]])?;
/// let start = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.25, 3.0]];
/// let direction = [[0.0; 3], [0.0; 3], [0.0; 3], [0.0, 0.0, -4.0]];
/// // At 0.75, the vertex would lie on the face.
/// assert_eq!(step_size(&mesh, &start, &direction, LineSearch::Exact)?, 0.75_f64.next_down());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn step_size(
    mesh: &TriangleMesh,
    start: &[Point],
    direction: &[Point],
    search: LineSearch<'_>,
) -> Result<f64, LineSearchError> {
    match search {
        LineSearch::Exact => {
            let options = FreeStepOptions::default().with_keep(1.0);
            let taken = Detector::new(mesh.clone()).free_step_along(start, direction, &options)?;
            Ok(taken.size)
        }
        LineSearch::Bisection { tolerance, method } => {
            check_positions(mesh.vertex_count(), direction).map_err(LineSearchError::Direction)?;
            let end = advance(start, direction, 1.0);
            let full = Step::new(mesh, start, &end)?;
            let value = tolerance.value();
            if value.is_nan() || value <= 0.0 {
                return Err(LineSearchError::Tolerance(value));
            }
            // The boxes of candidates have a margin for the rounded positions of smaller steps.
            let candidates = Candidates::new(full, &Bvh);
            Ok(bisect(tolerance, |size| {
                let end = advance(start, direction, size);
                Step::new(mesh, start, &end).is_ok_and(|step| !candidates.collides_by(step, method))
            }))
        }
    }
}
