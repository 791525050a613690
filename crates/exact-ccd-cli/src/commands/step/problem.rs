//! The problem of a step, and the answers to the questions about it.

use std::sync::Arc;

use exact_ccd::Options;
use exact_ccd_mesh::{CanCollide, Contact, Detector, Intersection, MinDistance, Motion};

use super::timed::Timed;
use crate::assembly::Assembly;
use crate::contacts::{ContactList, ContactRecord};
use crate::motion::counts::Pairs;
use crate::motion::half_spaces::{HalfSpaceCounts, HalfSpaces};

/// The answer to one of the questions of the command line about the mesh.
#[derive(Default)]
pub(super) struct Answer {
    pub(super) touches: bool,
    pub(super) earliest: Option<Contact>,
    pub(super) pairs: Option<Pairs>,
    /// All contacts, if the search for this answer listed them.
    pub(super) contacts: Option<Vec<Contact>>,
}

/// The answers to all questions: about the start, the half spaces, and the mesh in motion.
pub(super) struct Found {
    pub(super) start: Vec<Intersection>,
    /// The contacts with half spaces, the earliest first.
    pub(super) in_half_spaces: Vec<ContactRecord>,
    pub(super) half_spaces: Option<HalfSpaceCounts>,
    pub(super) answer: Answer,
}

impl Found {
    /// The intersections at the start and all contacts, in the order of their times.
    pub(super) fn list(&self, problem: &Problem<'_>, contacts: &[Contact]) -> ContactList {
        let start = self.start.iter().map(|&found| problem.record_of_start(found));
        let contacts = contacts.iter().map(|contact| problem.record(contact));
        let mut records: Vec<_> = start.chain(contacts).collect();
        records.extend(self.in_half_spaces.iter().cloned());
        records.sort_by(ContactRecord::compare_times);
        ContactList(records)
    }
}

/// A motion, its scene, and the meaning of contact in it.
pub(super) struct Problem<'a> {
    pub(super) scene: &'a Assembly,
    pub(super) motion: Motion,
    pub(super) can_collide: CanCollide,
    pub(super) distance: MinDistance,
    pub(super) half_spaces: HalfSpaces,
    pub(super) broad_phase: Arc<Timed>,
}

impl Problem<'_> {
    pub(super) fn detector(&self) -> Detector {
        let detector = Detector::with_broad_phase(self.motion.mesh.clone(), self.broad_phase.clone());
        detector.with_can_collide(self.can_collide.clone())
    }

    pub(super) fn options(&self) -> Options<MinDistance> {
        Options::within(self.distance.clone())
    }

    pub(super) fn record_of_start(&self, found: Intersection) -> ContactRecord {
        let Motion { mesh, x0, .. } = &self.motion;
        self.scene
            .in_file(ContactRecord::of_intersection(0, mesh, x0, found))
    }

    pub(super) fn record(&self, contact: &Contact) -> ContactRecord {
        let Motion { mesh, x0, x1 } = &self.motion;
        self.scene
            .in_file(ContactRecord::of_contact(0, mesh, [x0, x1], contact))
    }
}
