//! Two primitives of different bodies, and the decisions about them.

use exact_ccd::motion::{BodyPair, CurvedQuery};
use exact_ccd::{AnyKind, ContactTime, Impact, Kind, Options, with_kind};

use super::Bodies;
use super::shape::Shape;

/// Two primitives of different bodies that come near each other.
#[derive(Clone, Debug)]
pub(super) struct Candidate {
    pub(super) kind: AnyKind,
    /// The bodies of the first and of the second primitive.
    pub(super) bodies: [usize; 2],
    pub(super) primitives: [u32; 2],
    /// The motions of both bodies.
    pub(super) motions: BodyPair,
}

/// The order of candidates.
pub(super) type Key = (AnyKind, [usize; 2], [u32; 2]);

impl Candidate {
    pub(super) fn key(&self) -> Key {
        (self.kind, self.bodies, self.primitives)
    }

    pub(super) fn collides(&self, bodies: &Bodies, options: Options) -> bool {
        with_kind!(self.kind, K => self.query::<K>(bodies).is_some_and(|query| query.collides(options)))
    }

    /// Times between which the first contact is, if there may be one.
    pub(super) fn bracket(&self, bodies: &Bodies, options: Options) -> Option<[f64; 2]> {
        let bracket = with_kind!(self.kind, K => self.query::<K>(bodies)?.bracket(options));
        // Not known: any time.
        let bracket = bracket.unwrap_or([0.0, f64::INFINITY]);
        // A bracket that begins after the step is a proof that there is no contact.
        (bracket[0] <= 1.0).then_some(bracket)
    }

    pub(super) fn first_time(&self, bodies: &Bodies, options: Options) -> Option<ContactTime> {
        with_kind!(self.kind, K => self.query::<K>(bodies)?.first_time(options))
    }

    pub(super) fn impact(&self, bodies: &Bodies, options: Options) -> Option<Impact> {
        with_kind!(self.kind, K => self.query::<K>(bodies)?.impact(options))
    }

    /// The query of the primitives, whose coordinates are finite.
    fn query<K: Kind>(&self, bodies: &Bodies) -> Option<CurvedQuery<K>> {
        let mut points = K::Points::default();
        let shapes = Shape::of_kind(self.kind);
        let vertices = [0, 1].into_iter().flat_map(|i: usize| {
            let frame = &bodies.bodies[self.bodies[i]].frame;
            let vertices = shapes[i].vertices(&frame.mesh, self.primitives[i]);
            vertices
                .into_iter()
                .map(|vertex| frame.positions[vertex as usize])
        });
        for (target, point) in points.as_mut().iter_mut().zip(vertices) {
            *target = point;
        }
        self.motions.query(points).ok()
    }
}
