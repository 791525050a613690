//! Steps from poses to poses.

use exact_ccd::motion::{Chain, Pose, RigidMotion};
use exact_ccd::{ContactTime, Options};

use super::Bodies;
use super::candidate::{Candidate, Key};
use super::collect::AllContacts;
use super::contact::BodyContact;
use super::error::BodiesError;
use crate::pairs::PairCounts;

/// The contacts of a step of bodies, counted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodiesReport {
    /// The number of pairs of primitives that are in contact at some time of the step.
    pub colliding: PairCounts,
    /// The number of pairs that touch at t = 0.
    pub touching: PairCounts,
    /// The earliest contact, or `None` if the step is free of contact.
    pub earliest: Option<BodyContact>,
}

impl BodiesReport {
    /// Returns true if no two bodies touch during the step.
    #[must_use]
    pub fn is_free(&self) -> bool {
        self.earliest.is_none()
    }

    /// The largest f64 not above the earliest contact time, if there is contact.
    #[must_use]
    pub fn time_of_impact(&self) -> Option<f64> {
        self.earliest.map(|contact| contact.impact.time.lower())
    }
}

impl Bodies {
    /// Finds and counts the contacts of a step from poses at t = 0 to poses at t = 1, one for each body, by
    /// [`motions`](Self::motions).
    ///
    /// # Errors
    /// As [`motions`](Self::motions) and [`collides`](Self::collides).
    pub fn step(
        &self,
        poses0: &[Pose],
        poses1: &[Pose],
        options: impl Into<Options>,
    ) -> Result<BodiesReport, BodiesError> {
        let options = options.into();
        let motions = self.motions(poses0, poses1)?;
        let collector = AllContacts::new(self, options);
        self.search(&motions, options, &collector)?;
        let contacts = collector.list();
        let mut report = BodiesReport::default();
        for (time, candidate) in &contacts {
            report.colliding[candidate.kind] += 1;
            report.touching[candidate.kind] += usize::from(time.is_start());
        }
        let key = |(time, candidate): &&(ContactTime, Candidate)| -> (ContactTime, Key) {
            (*time, candidate.key())
        };
        let first = contacts.iter().min_by_key(key);
        report.earliest = first.and_then(|(_, candidate)| candidate.contact(self, options));
        Ok(report)
    }

    /// The motion of each body from one pose to another, as [`RigidMotion::between`]: the quaternion is
    /// linear, so that the opposite quaternion at the end is another way ([`Pose::nearer_turn`]).
    ///
    /// # Errors
    /// [`BodiesError::PoseCount`], if there is not one pose for each body at both ends;
    /// [`BodiesError::Motion`] names the body whose quaternion vanishes.
    pub fn motions(&self, poses0: &[Pose], poses1: &[Pose]) -> Result<Vec<Chain>, BodiesError> {
        let bodies = self.bodies.len();
        for poses in [poses0.len(), poses1.len()] {
            if poses != bodies {
                return Err(BodiesError::PoseCount { poses, bodies });
            }
        }
        let pairs = poses0.iter().zip(poses1).enumerate();
        let motions = pairs.map(|(body, (start, end))| {
            let motion = RigidMotion::between(start, end);
            let motion = motion.map_err(|error| BodiesError::Motion { body, error })?;
            Ok(motion.into())
        });
        motions.collect()
    }
}
