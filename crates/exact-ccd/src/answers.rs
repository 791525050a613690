//! The answers to a query: floating-point filters first, then the exact path.

use crate::collision::Collision;
use crate::environment;
use crate::exact;
use crate::filter::{self, Decision};
use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::stage::Stage;
use crate::time::ContactTimes;

impl<K: Kind> Query<K> {
    /// Returns true if the primitives touch at some time of the step.
    #[must_use]
    #[inline]
    pub fn collides(&self) -> bool {
        self.collides_with_stage().0
    }

    /// [`collides`](Self::collides), and the stage that settled it.
    #[must_use]
    #[inline]
    pub fn collides_with_stage(&self) -> (bool, Stage) {
        K::collides(self)
    }

    /// The collision, if the primitives touch: [`collides`](Self::collides) with the intermediate
    /// results from which all further answers follow.
    #[must_use]
    #[inline]
    pub fn collision(&self) -> Option<Collision<'_, K>> {
        K::collision(self).ok()
    }

    /// All times at which the primitives touch.
    #[must_use]
    pub fn contact_times(&self) -> ContactTimes {
        self.contact_times_with_stage().0
    }

    /// [`contact_times`](Self::contact_times), and the stage that settled it.
    #[must_use]
    pub fn contact_times_with_stage(&self) -> (ContactTimes, Stage) {
        match K::collision(self) {
            Ok(collision) => collision.contact_times_with_stage(),
            Err(stage) => (ContactTimes::NONE, stage),
        }
    }

    /// The largest f64 not above the earliest contact time, if there is one.
    #[must_use]
    pub fn time_of_impact(&self) -> Option<f64> {
        K::time_of_impact(self)
    }

    /// The earliest contact, if there is one: time, parameters and normal.
    #[must_use]
    pub fn impact(&self) -> Option<Impact> {
        K::first_impact(self)
    }
}

pub(crate) fn collides<K: Kind>(query: &Query<K>) -> (bool, Stage) {
    match decide(query) {
        Decision::Free(stage) => (false, stage),
        Decision::Contact(contact) => (true, contact.stage()),
        Decision::Unknown => (exact::collides(query), Stage::Exact),
    }
}

/// The collision, or the stage that proved that there is none.
#[inline]
pub(crate) fn collision<K: Kind>(query: &Query<K>) -> Result<Collision<'_, K>, Stage> {
    Collision::from_decision(query, decide(query))
}

pub(crate) fn time_of_impact<K: Kind>(query: &Query<K>) -> Option<f64> {
    let collision = collision(query).ok()?;
    Some(collision.determine_first_time().lower())
}

pub(crate) fn impact<K: Kind>(query: &Query<K>) -> Option<Impact> {
    let collision = collision(query).ok()?;
    Some(collision.determine_impact())
}

#[inline]
fn decide<K: Kind>(query: &Query<K>) -> Decision {
    if environment::is_default() {
        filter::decide(query)
    } else {
        Decision::Unknown
    }
}
