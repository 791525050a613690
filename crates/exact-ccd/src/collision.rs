//! A query that collides, and the answers about its contacts.

use alloc::boxed::Box;

use crate::exact::FirstContact;
use crate::filter::{Contact, Decision};
use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::stage::Stage;
use crate::time::{ContactTime, ContactTimes};

/// A query that [collides](Query::collides), with the intermediate results of that decision.
///
/// The times and the impact continue from these results: they cost less than
/// [`Query::contact_times`] and [`Query::impact`], which decide contact first, and are the same.
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

    /// The query.
    #[must_use]
    #[inline]
    pub fn query(&self) -> &'a Query<K> {
        self.query
    }

    /// The stage that decided contact.
    #[must_use]
    #[inline]
    pub fn stage(&self) -> Stage {
        match &self.proof {
            Proof::Filter(contact) => contact.stage(),
            Proof::Exact(_) => Stage::Exact,
        }
    }

    /// The earliest contact time.
    #[must_use]
    pub fn first_contact_time(&self) -> ContactTime {
        self.answer(|contact| contact.first(self.query), FirstContact::time)
            .0
    }

    /// The largest f64 not above the earliest contact time.
    #[must_use]
    pub fn time_of_impact(&self) -> f64 {
        self.first_contact_time().lower()
    }

    /// All times at which the primitives touch.
    #[must_use]
    pub fn contact_times(&self) -> ContactTimes {
        self.contact_times_with_stage().0
    }

    /// [`contact_times`](Self::contact_times), and the stage that determined them.
    #[must_use]
    pub fn contact_times_with_stage(&self) -> (ContactTimes, Stage) {
        self.answer(|contact| contact.times(self.query), FirstContact::times)
    }

    /// The earliest contact: time, parameters and normal.
    #[must_use]
    pub fn impact(&self) -> Impact {
        self.answer(|contact| contact.impact(self.query), FirstContact::impact)
            .0
    }

    /// An answer by the filters if they determine it, otherwise by the exact path, and its stage.
    fn answer<T>(
        &self,
        by_filter: impl FnOnce(&Contact) -> Option<T>,
        exactly: impl FnOnce(&FirstContact<K>) -> T,
    ) -> (T, Stage) {
        match &self.proof {
            Proof::Exact(first) => (exactly(first), Stage::Exact),
            Proof::Filter(contact) => match by_filter(contact) {
                Some(answer) => (answer, contact.stage()),
                None => {
                    // Cannot panic: the filters prove contact only where the exact path, which
                    // defines it, finds one.
                    let first = FirstContact::of(self.query).expect("a proved contact exists");
                    (exactly(&first), Stage::Exact)
                }
            },
        }
    }
}
