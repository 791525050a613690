//! Two primitives of different bodies, and the decisions about them.

use exact_ccd::motion::{BodyPair, CurvedQuery};
use exact_ccd::{AnyKind, ContactTime, Impact, Kind, Options, WithKind};

use super::Bodies;
use super::body::Set;

/// Two primitives of different bodies that come near each other.
#[derive(Clone, Debug)]
pub(super) struct Candidate {
    pub(super) kind: AnyKind,
    /// The sets of the first and of the second primitive.
    pub(super) sets: [Set; 2],
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
        self.ask(bodies, options, Question::Collides).is_some()
    }

    /// Times between which the first contact is, if there may be one.
    pub(super) fn bracket(&self, bodies: &Bodies, options: Options) -> Option<[f64; 2]> {
        match self.ask(bodies, options, Question::Bracket) {
            Some(Answer::Bracket(bracket)) => Some(bracket),
            _ => None,
        }
    }

    pub(super) fn first_time(&self, bodies: &Bodies, options: Options) -> Option<ContactTime> {
        match self.ask(bodies, options, Question::FirstTime) {
            Some(Answer::FirstTime(time)) => Some(time),
            _ => None,
        }
    }

    pub(super) fn impact(&self, bodies: &Bodies, options: Options) -> Option<Impact> {
        match self.ask(bodies, options, Question::Impact) {
            Some(Answer::Impact(impact)) => Some(impact),
            _ => None,
        }
    }

    fn ask(&self, bodies: &Bodies, options: Options, question: Question) -> Option<Answer> {
        self.kind.with(Ask {
            candidate: self,
            bodies,
            options,
            question,
        })
    }

    /// The query of the primitives, whose coordinates are finite.
    fn query<K: Kind>(&self, bodies: &Bodies) -> Option<CurvedQuery<K>> {
        let mut points = K::Points::default();
        let vertices = [0, 1].into_iter().flat_map(|i: usize| {
            let frame = &bodies.0[self.bodies[i]].frame;
            let vertices = self.sets[i].vertices(&frame.mesh, self.primitives[i]);
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

/// A question about a query whose kind is known at run time.
struct Ask<'a> {
    candidate: &'a Candidate,
    bodies: &'a Bodies,
    options: Options,
    question: Question,
}

#[derive(Clone, Copy)]
enum Question {
    Collides,
    Bracket,
    FirstTime,
    Impact,
}

enum Answer {
    Collides,
    Bracket([f64; 2]),
    FirstTime(ContactTime),
    Impact(Impact),
}

impl WithKind for Ask<'_> {
    type Output = Option<Answer>;

    fn with<K: Kind>(self) -> Option<Answer> {
        let query = self.candidate.query::<K>(self.bodies)?;
        let options = self.options;
        match self.question {
            Question::Collides => query.collides(options).then_some(Answer::Collides),
            Question::Bracket => match query.bracket(options) {
                // Not known, or known to be free.
                None => Some(Answer::Bracket([0.0, f64::INFINITY])),
                Some([start, _]) if start > 1.0 => None,
                Some(bracket) => Some(Answer::Bracket(bracket)),
            },
            Question::FirstTime => query.first_time(options).map(Answer::FirstTime),
            Question::Impact => query.impact(options).map(Answer::Impact),
        }
    }
}
