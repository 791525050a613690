//! A query that collides, and the answers about its contacts.

use alloc::boxed::Box;

use crate::distance::{DistanceBounds, Separation};
use crate::environment;
use crate::exact::{self, FirstContact, FirstWithin};
use crate::filter::{self, Contact, Decision, Proved};
use crate::impact::Impact;
use crate::interval::Intervals;
use crate::kind::Kind;
use crate::query::Query;
use crate::stage::Stage;
use crate::time::ContactTime;

/// A query that [collides](Query::collides), with the intermediate results of that decision.
///
/// The times and the impact continue from these results: they cost less than [`Query::intervals`] and
/// [`Query::impact`], which decide first, and are the same.
///
/// ```
/// use exact_ccd::{CONTACT, Query, VertexFace};
///
/// let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let at = |z: f64| [[0.25, 0.25, z], face[0], face[1], face[2]];
/// let query = Query::<VertexFace>::new(at(1.0), at(-1.0))?;
///
/// let collision = query.collision(CONTACT).expect("the vertex passes through the face");
/// assert_eq!(collision.time_of_impact(), 0.5);
/// assert_eq!(collision.intervals().count(), Some(1));
/// assert_eq!(collision.impact().normal, Some([0.0, 0.0, 1.0]));
/// # Ok::<(), exact_ccd::NonFinite>(())
/// ```
#[derive(Clone, Debug)]
pub struct Collision<'a, K: Kind> {
    query: &'a Query<K>,
    separation: Separation,
    proof: Proof<K>,
    /// The first time, once it is known.
    first: Option<ContactTime>,
}

/// The proof that a query collides.
#[derive(Clone, Debug)]
enum Proof<K> {
    Filter(Contact),
    Exact(Box<FirstContact<K>>),
    /// The first time within a separation above 0, and the stage that found it.
    Within(ContactTime, Stage),
    ExactWithin(Box<FirstWithin>),
}

impl<'a, K: Kind> Collision<'a, K> {
    /// The collision that follows from the outcome of the filters; the stage if there is none.
    #[inline]
    pub(crate) fn from_decision(
        query: &'a Query<K>,
        separation: Separation,
        decision: Decision,
    ) -> Result<Self, Stage> {
        let proof = match decision {
            Decision::Free(stage) => return Err(stage),
            Decision::Collision(Proved::Contact(contact)) => Proof::Filter(contact),
            Decision::Collision(Proved::Within(first, stage)) => Proof::Within(first, stage),
            Decision::Unknown if separation.is_zero() => {
                Proof::Exact(Box::new(FirstContact::of(query).ok_or(Stage::Exact)?))
            }
            Decision::Unknown => {
                Proof::ExactWithin(Box::new(FirstWithin::of(query, separation).ok_or(Stage::Exact)?))
            }
        };
        Ok(Self {
            query,
            separation,
            proof,
            first: None,
        })
    }

    /// The query.
    #[must_use]
    #[inline]
    pub fn query(&self) -> &'a Query<K> {
        self.query
    }

    /// The distance at which the primitives touch: 0 for contact.
    #[must_use]
    #[inline]
    pub fn separation(&self) -> Separation {
        self.separation
    }

    /// The stage that decided.
    #[must_use]
    #[inline]
    pub fn stage(&self) -> Stage {
        match &self.proof {
            Proof::Filter(contact) => contact.stage(),
            Proof::Exact(_) | Proof::ExactWithin(_) => Stage::Exact,
            Proof::Within(_, stage) => *stage,
        }
    }

    /// The first time at which the primitives touch.
    #[must_use]
    pub fn time(&self) -> ContactTime {
        K::time(self)
    }

    /// The same collision if its first time, which it keeps then, is not after the last one that counts.
    #[inline]
    pub(crate) fn until(self, until: f64) -> Option<Self> {
        if until >= 1.0 {
            return Some(self);
        }
        if let Proof::Filter(contact) = &self.proof
            && environment::is_default()
            && contact.bracket().is_some_and(|[low, _]| low >= until)
        {
            return None;
        }
        let first = self.time();
        first.is_at_most(until).then_some(Self {
            first: Some(first),
            ..self
        })
    }

    /// Returns true if the primitives first touch before a time. This takes less time than
    /// [`time`](Self::time) where an interval of the first time suffices.
    #[must_use]
    pub fn is_before(&self, time: f64) -> bool {
        if let Proof::Filter(contact) = &self.proof
            && environment::is_default()
            && let Some([low, high]) = contact.bracket()
        {
            if low >= time {
                return false;
            }
            if high <= time {
                return true;
            }
        }
        self.time().lower() < time
    }

    pub(crate) fn determine_time(&self) -> ContactTime {
        self.first.unwrap_or_else(|| {
            let by_filter = |contact: &Contact| contact.first(self.query);
            self.answer(by_filter, FirstContact::time, Some, FirstWithin::time)
        })
    }

    /// The largest f64 not above the first time at which the primitives touch.
    #[must_use]
    pub fn time_of_impact(&self) -> f64 {
        self.time().lower()
    }

    /// All times of the step at which the primitives touch.
    #[must_use]
    pub fn intervals(&self) -> Intervals {
        K::intervals(self)
    }

    pub(crate) fn determine_intervals(&self) -> Intervals {
        self.answer(
            |contact| contact.intervals(self.query),
            FirstContact::intervals,
            |first| filter::intervals_within(self.query, self.separation, first),
            FirstWithin::intervals,
        )
    }

    /// The first time at which the primitives touch, with the closest points then.
    #[must_use]
    pub fn impact(&self) -> Impact {
        K::impact(self)
    }

    pub(crate) fn determine_impact(&self) -> Impact {
        self.answer(
            |contact| {
                let exactly = || FirstContact::impact_at_start(self.query);
                let starts = || self.time().is_start();
                contact.impact(self.query).or_else(|| starts().then(exactly))
            },
            FirstContact::impact,
            |first| filter::impact_within(self.query, self.separation, first),
            FirstWithin::impact::<K>,
        )
    }

    /// Bounds of the distance of the primitives at the first time at which they touch.
    ///
    /// It is the separation itself, unless the primitives are closer already at t = 0.
    #[must_use]
    pub fn distance(&self) -> DistanceBounds {
        K::distance(self)
    }

    pub(crate) fn determine_distance(&self) -> DistanceBounds {
        if !self.separation.is_zero() && self.time().is_start() {
            return exact::distance_at(self.query, 0.0).expect("0 is a time of the step");
        }
        let d = self.separation.get();
        DistanceBounds { lower: d, upper: d }
    }

    /// An answer: by the filters if they determine it, otherwise by the exact path, for contact and for a
    /// separation above 0. The filters need the default environment of the thread that reads the answer:
    /// the query may have been decided on another one.
    fn answer<T>(
        &self,
        contact_by_filter: impl FnOnce(&Contact) -> Option<T>,
        contact: impl FnOnce(&FirstContact<K>) -> T,
        within_by_filter: impl FnOnce(ContactTime) -> Option<T>,
        within: impl FnOnce(&FirstWithin) -> T,
    ) -> T {
        let filters = environment::is_default();
        // Cannot panic: the filters prove contact, or nearness, only where the exact path, which defines
        // it, finds it.
        let first_contact = || FirstContact::of(self.query).expect("a proved contact exists");
        let first_within = || FirstWithin::of(self.query, self.separation).expect("a proved nearness exists");
        let by_filter = |first| filters.then(|| within_by_filter(first)).flatten();
        match &self.proof {
            Proof::Exact(first) => contact(first),
            Proof::Filter(proved) => {
                let filtered = filters.then(|| contact_by_filter(proved)).flatten();
                filtered.unwrap_or_else(|| contact(&first_contact()))
            }
            Proof::ExactWithin(first) => by_filter(first.time()).unwrap_or_else(|| within(first)),
            Proof::Within(first, _) => by_filter(*first).unwrap_or_else(|| within(&first_within())),
        }
    }
}
