//! Contacts of bodies.

use std::cmp::Ordering;

use exact_ccd::{AnyKind, Impact};

use super::Bodies;
use super::candidate::Candidate;

/// Two primitives of different bodies that touch in a step, and the first time at which they do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyContact {
    /// The kind of the pair.
    pub kind: AnyKind,
    /// The indices of the bodies of the first and of the second primitive. Of a vertex and a face or an edge,
    /// the vertex is first; of two edges or two vertices, the one of the lesser body.
    pub bodies: [usize; 2],
    /// The index of each primitive in the mesh of its body.
    pub primitives: [u32; 2],
    /// The time and the place of the first contact. The parameters are in this order of the primitives;
    /// the normal is in the coordinates of the world.
    pub impact: Impact,
}

impl BodyContact {
    pub(super) fn new(candidate: &Candidate, impact: Impact) -> Self {
        Self {
            kind: candidate.kind,
            bodies: candidate.bodies,
            primitives: candidate.primitives,
            impact,
        }
    }

    /// The order of contacts: by time, and at the same time by kind, bodies and primitives.
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        let key = |contact: &Self| {
            (
                contact.impact.time,
                contact.kind,
                contact.bodies,
                contact.primitives,
            )
        };
        key(self).cmp(&key(other))
    }
}

impl Candidate {
    /// The contact, if the primitives touch.
    pub(super) fn contact(&self, bodies: &Bodies, options: exact_ccd::Options) -> Option<BodyContact> {
        self.impact(bodies, options)
            .map(|impact| BodyContact::new(self, impact))
    }
}
