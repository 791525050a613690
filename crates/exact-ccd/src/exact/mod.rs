//! The definition: contact decided in integers, without rounding and without tolerance.
//!
//! Coordinates are dyadic rationals, so that a query is a set of integer polynomials in t. Contact begins and ends at
//! roots of one of them ([`Query`]'s four points become coplanar, or, if they always are, a vertex reaches an edge),
//! and whether the primitives touch at a root is a matter of the signs of others there. Every answer of this crate
//! is the one given here; the functions below give it without asking any filter, for audits.

mod dyadic;
mod guess;
mod impact;
mod instant;
mod modular;
mod motion;
mod narrowing;
mod polynomial;

pub(crate) use dyadic::to_integers;
pub(crate) use instant::roots;
pub(crate) use motion::{Vector, cross, dot};
pub(crate) use polynomial::Polynomial;

use instant::Instant;
use motion::Motion;

use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::time::{ContactTime, ContactTimes, Times};

/// [`Query::collides`], decided in integers alone.
#[must_use]
pub fn collides<K: Kind>(query: &Query<K>) -> bool {
    let motion = Motion::new(query);
    roots(motion.events())
        .iter()
        .any(|instant| motion.touches(instant))
}

/// [`Query::contact_times`], computed in integers alone.
#[must_use]
pub fn contact_times<K: Kind>(query: &Query<K>) -> ContactTimes {
    let motion = Motion::new(query);
    let instants = roots(motion.events());
    let mut times = Times::default();
    for (i, instant) in instants
        .iter()
        .enumerate()
        .filter(|(_, instant)| motion.touches(instant))
    {
        times.0.push(instant.round());
        // Contact that lasts begins at an event, and holds until the next one: the primitives are closed.
        let lasts = |next| motion.touches(&Instant::Dyadic(instant.before(next)));
        if motion.is_always_coplanar() && instants.get(i + 1).is_some_and(lasts) {
            return ContactTimes::Interval { first: times[0] };
        }
    }
    ContactTimes::Finite(times)
}

/// [`Query::time_of_impact`], computed in integers alone.
#[must_use]
pub fn time_of_impact<K: Kind>(query: &Query<K>) -> Option<f64> {
    contact_times(query).first().map(ContactTime::lower)
}

/// [`Query::impact`], computed in integers alone.
#[must_use]
pub fn impact<K: Kind>(query: &Query<K>) -> Option<Impact> {
    let motion = Motion::new(query);
    let instants = roots(motion.events());
    let first = instants.iter().find(|instant| motion.touches(instant))?;
    Some(motion.impact(first))
}
