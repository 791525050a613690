//! A query that collides, and the answers about its contacts.

use alloc::boxed::Box;
use alloc::vec::Vec;

use crate::environment;
use crate::exact::FirstContact;
use crate::exact::separation as exact;
use crate::filter::{Contact, Decision};
use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::separation::{DistanceBounds, Separation, TimeInterval};
use crate::stage::Stage;
use crate::time::{ContactTime, ContactTimes};

/// A query that [collides](Query::collides), or one whose primitives [come within a
/// separation](Query::comes_within), with the intermediate results of that decision.
///
/// The times and the impact continue from these results: they cost less than
/// [`Query::contact_times`] and [`Query::impact`], which decide contact first, and are the same. With
/// a separation d above 0, *contact* stands for a distance of at most d in all that follows.
///
/// ```
/// use exact_ccd::{Query, VertexFace};
///
/// let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let at = |z: f64| [[0.25, 0.25, z], face[0], face[1], face[2]];
/// let query = Query::<VertexFace>::new(at(1.0), at(-1.0))?;
///
/// let collision = query.collision().expect("the vertex passes through the face");
/// assert_eq!(collision.time_of_impact(), 0.5);
/// assert_eq!(collision.contact_times().count(), Some(1));
/// assert_eq!(collision.impact().normal, Some([0.0, 0.0, 1.0]));
/// # Ok::<(), exact_ccd::NonFinite>(())
/// ```
#[derive(Clone, Debug)]
pub struct Collision<'a, K> {
    query: &'a Query<K>,
    proof: Proof<K>,
}

/// The proof that a query collides.
#[derive(Clone, Debug)]
enum Proof<K> {
    Filter(Contact),
    Exact(Box<FirstContact<K>>),
    /// The first time within a separation above 0.
    Within(Separation, ContactTime),
}

impl<'a, K: Kind> Collision<'a, K> {
    /// The collision that follows from the outcome of the filters; `None` and the stage if there is
    /// no contact.
    #[inline]
    pub(crate) fn from_decision(query: &'a Query<K>, decision: Decision) -> Result<Self, Stage> {
        let proof = match decision {
            Decision::Free(stage) => return Err(stage),
            Decision::Contact(contact) => Proof::Filter(contact),
            Decision::Unknown => Proof::Exact(Box::new(FirstContact::of(query).ok_or(Stage::Exact)?)),
        };
        Ok(Self { query, proof })
    }

    /// The collision of primitives that are first within a separation above 0 at a time.
    #[inline]
    pub(crate) fn within(query: &'a Query<K>, separation: Separation, first: ContactTime) -> Self {
        let proof = Proof::Within(separation, first);
        Self { query, proof }
    }

    /// The query.
    #[must_use]
    #[inline]
    pub fn query(&self) -> &'a Query<K> {
        self.query
    }

    /// The distance at which primitives count as touching: 0 for contact.
    #[must_use]
    #[inline]
    pub fn separation(&self) -> Separation {
        match self.proof {
            Proof::Filter(_) | Proof::Exact(_) => Separation::default(),
            Proof::Within(separation, _) => separation,
        }
    }

    /// The earliest contact time.
    #[must_use]
    pub fn first_contact_time(&self) -> ContactTime {
        K::first_time(self)
    }

    pub(crate) fn determine_first_time(&self) -> ContactTime {
        let by_filter = |contact: &Contact| contact.first(self.query);
        self.answer(by_filter, FirstContact::time, |_, first| first)
    }

    /// The largest f64 not above the earliest contact time.
    #[must_use]
    pub fn time_of_impact(&self) -> f64 {
        self.first_contact_time().lower()
    }

    /// All times of contact. With a separation above 0, it is the interval from the first of them, even
    /// if the primitives leave again: [`intervals`](Self::intervals) has them all.
    #[must_use]
    pub fn contact_times(&self) -> ContactTimes {
        self.contact_times_with_stage().0
    }

    /// [`contact_times`](Self::contact_times), and the stage that determined them.
    #[must_use]
    pub fn contact_times_with_stage(&self) -> (ContactTimes, Stage) {
        K::times(self)
    }

    pub(crate) fn determine_times(&self) -> (ContactTimes, Stage) {
        self.answer(
            |contact| Some((contact.times(self.query)?, contact.stage())),
            |first| (first.times(), Stage::Exact),
            |_, first| (ContactTimes::Interval { first }, Stage::Exact),
        )
    }

    /// The maximal closed intervals of contact, in increasing order.
    #[must_use]
    pub fn intervals(&self) -> Vec<TimeInterval> {
        let d = self.separation();
        if d.is_zero()
            && let ContactTimes::Finite(times) = self.contact_times()
        {
            return times.iter().copied().map(TimeInterval::moment).collect();
        }
        exact::intervals_within(self.query, d)
    }

    /// The earliest contact: time, parameters and normal. With a separation above 0, the parameters
    /// and the normal are those of the closest points, see [`Query::impact_within`].
    #[must_use]
    pub fn impact(&self) -> Impact {
        K::impact(self)
    }

    pub(crate) fn determine_impact(&self) -> Impact {
        self.answer(
            |contact| contact.impact(self.query),
            FirstContact::impact,
            // Cannot panic: the filters prove what the exact path defines.
            |d, first| exact::impact_at(self.query, d, first).expect("a proved contact exists"),
        )
    }

    /// Bounds of the distance of the primitives at the earliest contact time.
    ///
    /// It is the separation itself, unless the primitives are closer already at t = 0.
    #[must_use]
    pub fn distance(&self) -> DistanceBounds {
        K::distance(self)
    }

    pub(crate) fn determine_distance(&self) -> DistanceBounds {
        let d = self.separation();
        let at_first_time = DistanceBounds {
            lower: d.get(),
            upper: d.get(),
        };
        if d.is_zero() {
            return at_first_time;
        }
        let first = self.first_contact_time();
        if first.is_start() {
            return exact::distance_at(self.query, 0.0).expect("0 is a time of the step");
        }
        at_first_time
    }

    /// An answer by the filters if they determine it, otherwise by the exact path; or that for a
    /// separation above 0, from it and from the first time. The filters need the default environment of the
    /// thread that reads the answer: the query may have been decided on another one.
    fn answer<T>(
        &self,
        by_filter: impl FnOnce(&Contact) -> Option<T>,
        exactly: impl FnOnce(&FirstContact<K>) -> T,
        within: impl FnOnce(Separation, ContactTime) -> T,
    ) -> T {
        match &self.proof {
            Proof::Exact(first) => exactly(first),
            Proof::Filter(contact) => {
                let filtered = environment::is_default().then(|| by_filter(contact)).flatten();
                filtered.unwrap_or_else(|| {
                    // Cannot panic: the filters prove contact only where the exact path, which defines
                    // it, finds one.
                    let first = FirstContact::of(self.query).expect("a proved contact exists");
                    exactly(&first)
                })
            }
            Proof::Within(d, first) => within(*d, *first),
        }
    }
}
