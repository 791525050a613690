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
    /// A box at rest around the path of each primitive, as in other software. Candidates are the pairs whose
    /// boxes overlap: all candidates of moving boxes, and more, the longer the paths are.
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
    /// Rounded positions on the path stay within the swept boxes, which are bounded by comparisons alone, or
    /// less than 2⁻¹⁰²² outside where subnormal numbers count as zero. They stay within moving boxes, which
    /// are larger by the error of rounding.
    pub(crate) fn margin(&self, step: &Step<'_>) -> Result<Margin, CandidateError> {
        let distance = self.distance;
        // As bits, negative numbers are larger than −0.0. A comparison of the numbers may read a subnormal
        // number as zero.
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

#[cfg(test)]
mod tests {
    use super::{BoxKind, CandidateOptions};
    use crate::mesh::TriangleMesh;
    use crate::steps::Step;

    /// At coordinates of any size, down to 0.
    #[test]
    fn margins_are_half_of_the_distance_and_those_of_moving_boxes_have_room_for_rounded_positions() {
        let mesh = TriangleMesh::new(2, Vec::new()).expect("there are no faces");
        for size in [0.0, f64::MIN_POSITIVE, 1e-300, 1e-9, 1.0, 1e6, 1e300] {
            let (x0, x1) = ([[0.0; 3], [size, 0.0, 0.0]], [[0.0; 3], [0.0, -0.5 * size, 0.0]]);
            let step = Step::new(&mesh, &x0, &x1).expect("all positions are finite");
            for distance in [-0.0, 0.0, 0.25 * size, size] {
                let [swept, moving] = [BoxKind::Swept, BoxKind::Moving].map(|boxes| {
                    let options = CandidateOptions::default()
                        .with_distance(distance)
                        .with_boxes(boxes);
                    let margin = options.margin(&step).expect("the distance is not negative");
                    margin.uniform().expect("the distance is the same for all pairs")
                });
                assert!(swept >= 0.5 * distance && swept <= 0.5 * distance + 4.0 * f64::MIN_POSITIVE);
                // 32 units of the largest coordinate, and four times what is flushed to zero.
                let least = 0.5 * distance + 32.0 * f64::EPSILON * size;
                assert!(
                    moving > least && moving >= 4.0 * f64::MIN_POSITIVE,
                    "{size} {distance}"
                );
                let most = (1.0 + 4.0 * f64::EPSILON) * least + 12.0 * f64::MIN_POSITIVE;
                assert!(moving <= most, "{size} {distance}");
            }
        }
    }
}
