//! All violations in a sequence of frames.

use exact_ccd::Options;
use exact_ccd_mesh::{
    Bvh, CanCollide, Detector, Frame, IntersectionOptions, MinDistance, MotionError, StepError, Violation,
    intersections,
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
        let among = IntersectionOptions::default().with_can_collide(self.can_collide.clone());
        let found = intersections(&frame.mesh, &frame.positions, &Bvh, &among).map_err(StepError::from)?;
        let options = Options::within(self.min_distance.clone());
        let (detector, contacts) = match self.last.take() {
            Some((last, mut detector)) => {
                last.mesh.check_same(&frame.mesh)?;
                let contacts = detector.collisions(&last.positions, &frame.positions, options)?;
                (detector, contacts)
            }
            None => {
                self.min_distance.check(&frame.mesh)?;
                let detector = Detector::new(frame.mesh.clone());
                let mut detector = detector.with_can_collide(self.can_collide.clone());
                let contacts = if self.is_only_frame {
                    detector.collisions(&frame.positions, &frame.positions, options)?
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
