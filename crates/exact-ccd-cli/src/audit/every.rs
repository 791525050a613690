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
        let mut violations = Vec::new();
        if let Some((last, detector)) = &mut self.last {
            last.mesh.check_same(&frame.mesh)?;
            let contacts = detector.collisions(&last.positions, &frame.positions, options)?;
            let frame_before = self.frames - 1;
            violations.extend(contacts.into_iter().map(|contact| Violation::Contact {
                frame: frame_before,
                contact,
            }));
            *last = frame;
        } else {
            self.min_distance.check(&frame.mesh)?;
            let mut detector = Detector::new(frame.mesh.clone()).with_can_collide(self.can_collide.clone());
            if self.is_only_frame {
                let contacts = detector.collisions(&frame.positions, &frame.positions, options)?;
                violations.extend(
                    contacts
                        .into_iter()
                        .map(|contact| Violation::Contact { frame: 0, contact }),
                );
            }
            self.last = Some((frame, detector));
        }
        let frame = self.frames;
        violations.extend(
            found
                .into_iter()
                .map(|intersection| Violation::Intersection { frame, intersection }),
        );
        self.frames += 1;
        Ok(violations)
    }

    pub(super) fn last(&self) -> Option<&Frame> {
        self.last.as_ref().map(|(frame, _)| frame)
    }
}
