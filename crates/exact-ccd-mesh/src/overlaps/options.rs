//! Options of the search for candidates.

use super::margin::{Margin, half};
use crate::pairs::{CanCollide, MinDistance, ThicknessCount};
use crate::steps::Step;

/// Options of the search for [`Candidates`](crate::Candidates). The default is all pairs whose boxes, each
/// moving with its primitive, meet in the step.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct CandidateOptions {
    /// All pairs that come within this distance beyond their minimum distance at some time of the step
    /// are candidates. 0 for contact.
    pub distance: f64,
    /// The distance within which pairs touch, according to [`Candidates`](crate::Candidates).
    pub min_distance: MinDistance,
    /// The boxes of primitives over the step.
    pub boxes: BoxKind,
    /// The pairs that can collide.
    pub can_collide: CanCollide,
}

/// The boxes of primitives over a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BoxKind {
    /// A box that moves with each primitive. Candidates are the pairs whose boxes no axis
    /// separates, in the same order, at both ends of the step. A motion that all primitives have in common
    /// does not matter.
    #[default]
    Moving,
    /// A box at rest around the path of each primitive, as other software has. Candidates are the pairs whose
    /// boxes overlap: those of moving boxes, and more, the longer the paths are.
    Swept,
}

/// The reason why there are no candidates.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CandidateError {
    /// The distance of [`CandidateOptions`] is negative or not a number.
    #[error("the distance of candidates is {0}, expected a number that is not negative")]
    Distance(f64),
    /// The minimum distance does not fit the mesh.
    #[error(transparent)]
    ThicknessCount(#[from] ThicknessCount),
}

/// The largest error of rounded positions for which moving boxes are prepared, in units of the
/// largest coordinate.
///
/// Errors are in units of ε M, M being the largest absolute value of a coordinate. Positions
/// between start and end, by [`Step::at`](crate::Step::at) or [`advance`](crate::advance), are off
/// by at most 3. In a scene that has been shifted by the displacement of its box, coordinates are
/// at most 4 M: the shift itself is off by ½ · 4 = 2, and positions between the shifted ones by 3 ·
/// 4 = 12. That is 14 in total, and twice as much where a thread rounds in another direction than to
/// nearest.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

impl CandidateOptions {
    /// The same options with another distance.
    #[must_use]
    pub fn with_distance(self, distance: f64) -> Self {
        Self { distance, ..self }
    }

    /// The same options with another minimum distance.
    #[must_use]
    pub fn with_min_distance(self, min_distance: impl Into<MinDistance>) -> Self {
        let min_distance = min_distance.into();
        Self { min_distance, ..self }
    }

    /// The same options with another kind of boxes.
    #[must_use]
    pub fn with_boxes(self, boxes: BoxKind) -> Self {
        Self { boxes, ..self }
    }

    /// The same options with another predicate.
    #[must_use]
    pub fn with_can_collide(self, can_collide: CanCollide) -> Self {
        Self { can_collide, ..self }
    }

    /// The margins of the boxes in a step.
    ///
    /// Rounded positions on the path: they stay within the swept boxes, which are bounded by
    /// comparisons alone, and within moving boxes that are larger by the error of rounding.
    pub(crate) fn margin(&self, step: &Step<'_>) -> Result<Margin, CandidateError> {
        let distance = self.distance;
        // The bits of negative numbers are above those of −0.0. A comparison may read a subnormal number as
        // zero.
        if distance.is_nan() || distance.to_bits() > (-0.0_f64).to_bits() {
            return Err(CandidateError::Distance(distance));
        }
        self.min_distance.check(step.mesh())?;
        let half = half(distance);
        let common = match self.boxes {
            BoxKind::Swept => half,
            BoxKind::Moving => {
                // The last summand covers products that underflow, or are flushed to zero.
                (half + (ROUNDING * step.largest_coordinate() + 4.0 * f64::MIN_POSITIVE)).next_up()
            }
        };
        Ok(Margin::new(self.min_distance.clone(), common))
    }
}
