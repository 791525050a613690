//! Steps that a detector answers.

use exact_ccd::{Options, Point};
use exact_ccd_mesh::{Bvh, Detector, IntersectionOptions, Meeting, StepError, intersections};

use crate::maker::{Maker, MakerError};

impl Maker {
    /// Adds the step of a detector's mesh from `x0` to `x1`. The certificate proves the earliest contact that
    /// the detector finds and, if `rest` is true, that no edge pierces a face at the start.
    ///
    /// # Errors
    /// [`MakerError::Rules`] if not all pairs can collide; [`MakerError::Step`] for positions that are no
    /// step and, if `rest` is true, for an edge that pierces a face.
    pub fn add_step_of(
        &mut self,
        detector: &mut Detector,
        x0: &[Point],
        x1: &[Point],
        rest: bool,
    ) -> Result<(), MakerError> {
        if !detector.can_collide().is_all() {
            return Err(MakerError::Rules);
        }
        if rest {
            let options = IntersectionOptions::default().with_meeting(Meeting::Crossing);
            let found = intersections(detector.mesh(), x0, &Bvh, &options).map_err(StepError::from)?;
            if let Some(first) = found.first() {
                return Err(MakerError::Step(first.crossing(detector.mesh())));
            }
        }
        let earliest = detector.collision(x0, x1, Options::within(self.distance))?;
        self.add_step(detector.mesh(), [x0, x1], rest, earliest.as_ref())
    }
}
