//! How far a mesh can go along a direction before it touches itself.

use exact_ccd::parity::Rounded;
use exact_ccd::{EdgeEdge, Point, Query, VertexFace};
use rayon::prelude::*;

use crate::broad_phase::Bvh;
use crate::candidates::Candidates;
use crate::detector::Detector;
use crate::mesh::TriangleMesh;
use crate::positions::{self, PositionsError};
use crate::step::{Step, StepError};

/// A method that decides contact, for [`LineSearch::Bisection`].
pub trait Decision: Sync {
    /// Whether a vertex and a face collide.
    fn vertex_face(&self, query: &Query<VertexFace>) -> bool;

    /// Whether two edges collide.
    fn edge_edge(&self, query: &Query<EdgeEdge>) -> bool;
}

/// Decides by [`Query::collides`](exact_ccd::Query::collides).
#[derive(Clone, Copy, Debug, Default)]
pub struct ExactDecision;

/// Decides by the parity of the number of contacts of the rounded query, as the paper does: two contacts look like none, and so does one
/// that only grazes.
///
/// A query that is too large to be rounded counts as a collision.
#[derive(Clone, Copy, Debug, Default)]
pub struct ParityDecision;

impl Decision for ExactDecision {
    fn vertex_face(&self, query: &Query<VertexFace>) -> bool {
        query.collides()
    }

    fn edge_edge(&self, query: &Query<EdgeEdge>) -> bool {
        query.collides()
    }
}

impl Decision for ParityDecision {
    fn vertex_face(&self, query: &Query<VertexFace>) -> bool {
        Rounded::shift(query).map_or(true, |rounded| rounded.parity().is_collision())
    }

    fn edge_edge(&self, query: &Query<EdgeEdge>) -> bool {
        Rounded::shift(query).map_or(true, |rounded| rounded.parity().is_collision())
    }
}

/// How [`step_size`] looks for the step.
#[derive(Clone, Copy)]
pub enum LineSearch<'a> {
    /// From the exact time of impact of the full step.
    Exact,
    /// By bisection: B. Wang, Z. Ferguson, X. Jiang, M. Attene, D. Panozzo, T. Schneider, *Fast and Exact Root Parity for
    /// Continuous Collision Detection*, 2022, algorithm 2.
    Bisection {
        /// At which width of the interval to stop, in units of the full step.
        tolerance: f64,
        /// What decides whether a step is free.
        decision: &'a dyn Decision,
    },
}

/// What keeps a line search from starting.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LineSearchError {
    /// The start, or the end of the full step, is not sound.
    #[error(transparent)]
    Step(#[from] StepError),
    /// The direction is not sound.
    #[error("in the direction, {0}")]
    Direction(#[source] PositionsError),
    /// The tolerance of a bisection is not positive.
    #[error("the tolerance is {0}, expected a positive number")]
    Tolerance(f64),
}

/// How large a step along a direction may be: the positions `start` + α `direction`, rounded, can be reached from `start`
/// without contact.
///
/// The result is in [0, 1]; 1 if the full step is free, 0 if the mesh touches itself already. Unless it is 0, with
/// [`LineSearch::Exact`] and with [`ExactDecision`] the step from `start` to [`advance`]`(start, direction, α)` has been
/// checked to be free of contact, exactly, with the rounding of the positions at its end.
///
/// With [`LineSearch::Exact`], α is the time of impact of the full step, or that less one, two, four, … units in its last
/// place: the first for which this is so. A bisection returns a step that is smaller by up to its tolerance. Either is
/// so up to the rounding of the positions: where that decides, a larger step can be free again.
///
/// # Errors
/// [`LineSearchError`] says which positions or parts of the direction are too many, too few or not finite.
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
    positions::check(mesh, direction).map_err(LineSearchError::Direction)?;
    let end = advance(start, direction, 1.0);
    let full = Step::new(mesh, start, &end)?;
    match search {
        LineSearch::Exact => {
            let mut detector = Detector::new(mesh);
            let Some(contact) = detector.earliest_contact_of(&full) else {
                return Ok(1.0);
            };
            let impact = contact.impact.time.lower();
            let mut size = impact;
            let mut retreat = impact - impact.next_down();
            while size > 0.0 && !detector.is_free(start, &advance(start, direction, size))? {
                size = (impact - retreat).max(0.0);
                retreat *= 2.0;
            }
            Ok(size)
        }
        LineSearch::Bisection { tolerance, decision } => {
            if tolerance.is_nan() || tolerance <= 0.0 {
                return Err(LineSearchError::Tolerance(tolerance));
            }
            // Rounding is monotone: on the way to a smaller step no coordinate leaves the box of the full one.
            let candidates = Candidates::new(full, &Bvh);
            let is_free = |size: f64, decision: &dyn Decision| -> Result<bool, StepError> {
                let end = advance(start, direction, size);
                Ok(is_free(&candidates, Step::new(mesh, start, &end)?, decision))
            };
            if is_free(1.0, decision)? {
                return Ok(1.0);
            }
            let (mut free, mut blocked) = (0.0, 1.0);
            while blocked - free > tolerance {
                let middle = free + 0.5 * (blocked - free);
                if middle <= free || middle >= blocked {
                    break;
                }
                if is_free(middle, decision)? {
                    free = middle;
                } else {
                    blocked = middle;
                }
            }
            Ok(free)
        }
    }
}

/// The positions after a step along a direction: x + fl(α d), rounded.
#[must_use]
pub fn advance(start: &[Point], direction: &[Point], size: f64) -> Vec<Point> {
    let along = |(x, d): (&Point, &Point)| core::array::from_fn(|axis| x[axis] + size * d[axis]);
    start.iter().zip(direction).map(along).collect()
}

fn is_free(candidates: &Candidates<'_>, step: Step<'_>, decision: &dyn Decision) -> bool {
    let faces = candidates.vertex_face().par_iter();
    let edges = candidates.edge_edge().par_iter();
    !faces
        .filter_map(|&[vertex, face]| step.vertex_face(vertex, face))
        .any(|query| decision.vertex_face(&query))
        && !edges
            .filter_map(|&[a, b]| step.edge_edge(a, b))
            .any(|query| decision.edge_edge(&query))
}
