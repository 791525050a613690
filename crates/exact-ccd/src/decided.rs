//! The decision that two primitives touch, and the answers that follow from it.

use crate::environment;
use crate::exact::{self, First, FirstContact};
use crate::filter::{self, Contact, Decision, Proved};
use crate::tables::{Points, Tables};
use crate::values::{CONTACT, ContactTime, DistanceBounds, Impact, Intervals, Separation, Stage};

/// The decision that two primitives touch, with the intermediate results from which all answers follow. The
/// points are those of the decision.
#[derive(Clone, Debug)]
#[expect(
    unnameable_types,
    reason = "an argument of hidden functions of a sealed trait"
)]
pub struct Decided<K> {
    separation: Separation,
    proof: Proof<K>,
    /// The first time, once it is known.
    first: Option<ContactTime>,
}

/// The proof that the primitives touch.
#[derive(Clone, Debug)]
enum Proof<K> {
    Contact(Contact),
    /// The first time within a separation above 0, and the stage that found it.
    Within(ContactTime, Stage),
    Exact(First<K>),
}

impl<K: Tables> Decided<K> {
    /// The decision by the outcome of the filters; the stage if the primitives do not touch.
    #[inline]
    pub(crate) fn from_filters(
        points: &Points<f64>,
        separation: Separation,
        decision: Decision,
    ) -> Result<Self, Stage> {
        let proof = match decision {
            Decision::Free(stage) => return Err(stage),
            Decision::Collision(Proved::Contact(contact)) => Proof::Contact(contact),
            Decision::Collision(Proved::Within(first, stage)) => Proof::Within(first, stage),
            Decision::Unknown => Proof::Exact(First::of(points, separation).ok_or(Stage::Exact)?),
        };
        Ok(Self {
            separation,
            proof,
            first: None,
        })
    }

    /// The distance at which the primitives touch: 0 for contact.
    #[inline]
    pub(crate) fn separation(&self) -> Separation {
        self.separation
    }

    /// The stage that decided.
    #[inline]
    pub(crate) fn stage(&self) -> Stage {
        match &self.proof {
            Proof::Contact(contact) => contact.stage(),
            Proof::Within(_, stage) => *stage,
            Proof::Exact(_) => Stage::Exact,
        }
    }

    /// The same if the first time, which it keeps then, is not after the last one that counts.
    #[inline]
    pub(crate) fn until(self, points: &Points<f64>, until: f64) -> Option<Self> {
        if until >= 1.0 {
            return Some(self);
        }
        if self.bracket().is_some_and(|[low, _]| low >= until) {
            return None;
        }
        let first = self.time(points);
        first.is_at_most(until).then_some(Self {
            first: Some(first),
            ..self
        })
    }

    /// Two times between which the first one certainly is, if they are known without further computation.
    #[inline]
    pub(crate) fn bracket(&self) -> Option<[f64; 2]> {
        match &self.proof {
            Proof::Contact(contact) if environment::is_default() => contact.bracket(),
            _ => None,
        }
    }

    /// The first time at which the primitives touch.
    #[inline(never)]
    pub(crate) fn time(&self, points: &Points<f64>) -> ContactTime {
        self.first.unwrap_or_else(|| {
            let by_filter = |contact: &Contact| contact.first::<K>(points);
            self.answer(points, by_filter, Some, First::time)
        })
    }

    /// All times of the step at which the primitives touch.
    pub(crate) fn intervals(&self, points: &Points<f64>) -> Intervals {
        self.answer(
            points,
            |contact| contact.intervals::<K>(points),
            |first| filter::intervals_within::<K>(points, self.separation, first),
            First::intervals,
        )
    }

    /// The first time, with the closest points then. The last time that counts changes no bit: contact at
    /// that time may be decided by another stage than in the whole step, which has the impact.
    pub(crate) fn impact(&self, points: &Points<f64>) -> Impact {
        if let Proof::Contact(Contact::At(_)) = &self.proof
            && environment::is_default()
        {
            let decision = filter::decide::<K>(points, &CONTACT);
            if let Ok(of_whole) = Self::from_filters(points, self.separation, decision) {
                return of_whole.impact_as_decided(points);
            }
        }
        self.impact_as_decided(points)
    }

    fn impact_as_decided(&self, points: &Points<f64>) -> Impact {
        self.answer(
            points,
            |contact| {
                let exactly = || FirstContact::<K>::impact_at_start(points);
                let starts = || self.time(points).is_start();
                contact.impact::<K>(points).or_else(|| starts().then(exactly))
            },
            |first| filter::impact_within::<K>(points, self.separation, first),
            First::impact,
        )
    }

    /// Bounds of the distance at the first time.
    pub(crate) fn distance(&self, points: &Points<f64>) -> DistanceBounds {
        if !self.separation.is_zero() && self.time(points).is_start() {
            return exact::distance_at::<K>(points, 0.0);
        }
        let d = self.separation.get();
        DistanceBounds { lower: d, upper: d }
    }

    /// An answer: by the filters if they determine it, for contact or for a separation above 0, otherwise by
    /// the exact path. The filters need the default environment of the thread that reads the answer: the
    /// query may have been decided on another one.
    fn answer<T>(
        &self,
        points: &Points<f64>,
        contact: impl FnOnce(&Contact) -> Option<T>,
        within: impl FnOnce(ContactTime) -> Option<T>,
        exact: impl FnOnce(&First<K>) -> T,
    ) -> T {
        let filtered = match &self.proof {
            _ if !environment::is_default() => None,
            Proof::Contact(proved) => contact(proved),
            Proof::Within(first, _) => within(*first),
            Proof::Exact(First::Within(first)) => within(first.time()),
            Proof::Exact(First::Contact(_)) => None,
        };
        filtered.unwrap_or_else(|| match &self.proof {
            Proof::Exact(first) => exact(first),
            // Cannot panic: the filters prove contact, or nearness, only where the exact path, which defines
            // it, finds it.
            _ => exact(&First::of(points, self.separation).expect("a proved contact exists")),
        })
    }
}
