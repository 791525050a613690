//! A query that collides, and the answers about its contacts.

use crate::environment;
use crate::exact::{self, First, FirstContact};
use crate::filter::{self, Contact, Decision, Proved};
use crate::kind::Kind;
use crate::query::Query;
use crate::values::{ContactTime, DistanceBounds, Impact, Intervals, Separation, Stage};

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
    Contact(Contact),
    /// The first time within a separation above 0, and the stage that found it.
    Within(ContactTime, Stage),
    Exact(First<K>),
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
            Decision::Collision(Proved::Contact(contact)) => Proof::Contact(contact),
            Decision::Collision(Proved::Within(first, stage)) => Proof::Within(first, stage),
            Decision::Unknown => Proof::Exact(First::of(&query.four(), separation).ok_or(Stage::Exact)?),
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
            Proof::Contact(contact) => contact.stage(),
            Proof::Within(_, stage) => *stage,
            Proof::Exact(_) => Stage::Exact,
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
        if let Proof::Contact(contact) = &self.proof
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
        if let Proof::Contact(contact) = &self.proof
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
        self.time().is_before(time)
    }

    pub(crate) fn determine_time(&self) -> ContactTime {
        self.first.unwrap_or_else(|| {
            let by_filter = |contact: &Contact| contact.first::<K>(&self.query.four());
            self.answer(by_filter, Some, First::time)
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
            |contact| contact.intervals::<K>(&self.query.four()),
            |first| filter::intervals_within::<K>(&self.query.four(), self.separation, first),
            First::intervals,
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
                let exactly = || FirstContact::<K>::impact_at_start(&self.query.four());
                let starts = || self.time().is_start();
                contact
                    .impact::<K>(&self.query.four())
                    .or_else(|| starts().then(exactly))
            },
            |first| filter::impact_within::<K>(&self.query.four(), self.separation, first),
            First::impact,
        )
    }

    /// Bounds of the distance of the primitives at the first time at which they touch.
    ///
    /// The distance is the separation, unless the primitives are closer than that at t = 0.
    #[must_use]
    pub fn distance(&self) -> DistanceBounds {
        K::distance(self)
    }

    pub(crate) fn determine_distance(&self) -> DistanceBounds {
        if !self.separation.is_zero() && self.time().is_start() {
            return exact::distance_at::<K>(&self.query.four(), 0.0);
        }
        let d = self.separation.get();
        DistanceBounds { lower: d, upper: d }
    }

    /// An answer: by the filters if they determine it, for contact or for a separation above 0, otherwise by
    /// the exact path. The filters need the default environment of the thread that reads the answer: the
    /// query may have been decided on another one.
    fn answer<T>(
        &self,
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
            _ => exact(&First::of(&self.query.four(), self.separation).expect("a proved contact exists")),
        })
    }
}
