//! A query that collides, and the answers about its contacts.

use crate::decided::Decided;
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
    decided: Decided<K>,
}

impl<'a, K: Kind> Collision<'a, K> {
    #[inline]
    pub(crate) fn new(query: &'a Query<K>, decided: Decided<K>) -> Self {
        Self { query, decided }
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
        self.decided.separation()
    }

    /// The stage that decided.
    #[must_use]
    #[inline]
    pub fn stage(&self) -> Stage {
        self.decided.stage()
    }

    /// The first time at which the primitives touch.
    #[must_use]
    pub fn time(&self) -> ContactTime {
        K::time(&self.decided, self.query.points())
    }

    /// Returns true if the primitives first touch before a time. This takes less time than
    /// [`time`](Self::time) where an interval of the first time suffices.
    #[must_use]
    pub fn is_before(&self, time: f64) -> bool {
        if let Some([low, high]) = self.decided.bracket() {
            if low >= time {
                return false;
            }
            if high <= time {
                return true;
            }
        }
        self.time().is_before(time)
    }

    /// The largest f64 not above the first time at which the primitives touch.
    #[must_use]
    pub fn time_of_impact(&self) -> f64 {
        self.time().lower()
    }

    /// All times of the step at which the primitives touch.
    #[must_use]
    pub fn intervals(&self) -> Intervals {
        K::intervals(&self.decided, self.query.points())
    }

    /// The first time at which the primitives touch, with the closest points then.
    #[must_use]
    pub fn impact(&self) -> Impact {
        K::impact(&self.decided, self.query.points())
    }

    /// Bounds of the distance of the primitives at the first time at which they touch.
    ///
    /// The distance is the separation, unless the primitives are closer than that at t = 0.
    #[must_use]
    pub fn distance(&self) -> DistanceBounds {
        K::distance(&self.decided, self.query.points())
    }
}
