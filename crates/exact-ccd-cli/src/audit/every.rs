//! All violations in a sequence of frames.

use exact_ccd_mesh::{
    CanCollide, Detector, Frame, MinDistance, MotionError, StepError, Violation, intersections_among,
};

/// Examines every frame at rest, and every step, whatever the frames before it had.
pub(super) struct EveryViolation {
    last: Option<(Frame, Detector)>,
    frames: usize,
    min_distance: MinDistance,
    can_collide: CanCollide,
    /// True if there is no step that examines the contacts in the first frame.
    is_only_frame: bool,
}

impl EveryViolation {
    pub(super) fn new(min_distance: MinDistance, can_collide: CanCollide, is_only_frame: bool) -> Self {
        Self {
            last: None,
            frames: 0,
            min_distance,
            can_collide,
            is_only_frame,
        }
    }

    /// The contacts in the step that leads to the next frame, in the order of time, then the
    /// intersections in that frame.
    pub(super) fn examine(&mut self, frame: Frame) -> Result<Vec<Violation>, MotionError> {
        let found =
            intersections_among(&frame.mesh, &frame.positions, &self.can_collide).map_err(StepError::from)?;
        let (detector, contacts) = match self.last.take() {
            Some((last, mut detector)) => {
                last.mesh.check_same(&frame.mesh)?;
                let contacts = detector.contacts(&last.positions, &frame.positions, 1.0)?;
                (detector, contacts)
            }
            None => {
                let detector = Detector::new(frame.mesh.clone()).with_can_collide(self.can_collide.clone());
                let mut detector = detector.with_min_distance(self.min_distance.clone())?;
                let contacts = if self.is_only_frame {
                    detector.contacts(&frame.positions, &frame.positions, 1.0)?
                } else {
                    Vec::new()
                };
                (detector, contacts)
            }
        };
        self.last = Some((frame, detector));
        let frame = self.frames;
        self.frames += 1;
        let in_step = contacts.into_iter().map(|contact| Violation::Contact {
            frame: frame.saturating_sub(1),
            contact,
        });
        let at_rest = found
            .into_iter()
            .map(|intersection| Violation::Intersection { frame, intersection });
        Ok(in_step.chain(at_rest).collect())
    }

    pub(super) fn last(&self) -> Option<&Frame> {
        self.last.as_ref().map(|(frame, _)| frame)
    }
}
