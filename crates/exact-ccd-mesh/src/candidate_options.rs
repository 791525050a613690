//! Options of the search for candidates.

use exact_ccd::Point;

use crate::can_collide::CanCollide;

/// Options of the search for [`Candidates`](crate::Candidates). The default is all pairs whose
/// boxes over the step overlap.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct CandidateOptions {
    /// All pairs that come within this distance of each other at some time of the step are
    /// candidates. 0 for contact.
    pub distance: f64,
    /// The boxes of primitives over the step.
    pub boxes: BoxKind,
    /// The pairs that can collide.
    pub can_collide: CanCollide,
}

/// The boxes of primitives over a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BoxKind {
    /// A box at rest around the path of each primitive. Candidates are the pairs whose boxes
    /// overlap.
    #[default]
    Swept,
    /// A box that moves with each primitive. Candidates are the pairs whose boxes no axis
    /// separates, in the same order, at both ends of the step. There are fewer of them, most of all
    /// if the parts of a mesh move together.
    Moving,
}

/// The distance of [`CandidateOptions`] is negative or not a number.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the distance of candidates is {0}, expected a number that is not negative")]
pub struct DistanceError(pub f64);

/// The largest error of rounded positions for which moving boxes are prepared, in units of the
/// largest coordinate.
///
/// Errors are in units of ε M, M being the largest absolute value of a coordinate. Positions
/// between start and end, by [`Step::at`](crate::Step::at) or [`advance`](crate::advance), are off
/// by at most 3. In a scene that has been shifted by the displacement of its box, coordinates are
/// at most 4 M: the shift itself is off by ½ · 4 = 2, and positions between the shifted ones by 3 ·
/// 4 = 12. That is 14 in total.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl CandidateOptions {
    /// The same options with another distance.
    #[must_use]
    pub fn with_distance(self, distance: f64) -> Self {
        Self { distance, ..self }
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

    /// The amount by which each side of each box is moved outwards.
    ///
    /// If two primitives are within d of each other at a time, then each coordinate of two of their
    /// points differs by at most d there. Each point is in the box of its primitive at that time.
    /// So boxes that are larger by at least d/2 on each side meet at that time, and no axis
    /// separates them at both ends in the same order.
    ///
    /// Rounded positions on the path: they stay within the swept boxes, which are bounded by
    /// comparisons alone, and within moving boxes that are larger by the error of rounding.
    pub(crate) fn margin(&self, positions: [&[Point]; 2]) -> Result<f64, DistanceError> {
        let distance = self.distance;
        if distance.is_nan() || distance < 0.0 {
            return Err(DistanceError(distance));
        }
        // Half of a subnormal number may be rounded down.
        let half = match 0.5 * distance {
            half if half + half < distance => half.next_up(),
            half => half,
        };
        Ok(match self.boxes {
            BoxKind::Swept => half,
            BoxKind::Moving => {
                let coordinates = positions.into_iter().flatten().flatten();
                let largest = coordinates.fold(0.0_f64, |largest, x| largest.max(x.abs()));
                // The smallest normal number covers products that underflow.
                (half + (ROUNDING * largest + f64::MIN_POSITIVE)).next_up()
            }
        })
    }
}
