//! The definition: contact decided in integers, without rounding and without tolerance.
//!
//! Coordinates are dyadic rationals, so that a query is a set of integer polynomials in t. Contact begins and ends at
//! roots of one of them ([`Query`]'s four points become coplanar, or, if they always are, a vertex reaches an edge),
//! and whether the primitives touch at a root is a matter of the signs of others there. Every answer of this crate
//! is the one given here; the functions below give it without asking any filter, for audits.

mod dyadic;
mod instant;
mod motion;
mod polynomial;
mod sturm;

use alloc::vec::Vec;

use instant::Instant;
use motion::Motion;

use crate::kind::Kind;
use crate::query::Query;
use crate::time::{ContactTime, ContactTimes, Times};

/// [`Query::collides`], decided in integers alone.
#[must_use]
pub fn collides<K: Kind>(query: &Query<K>) -> bool {
    !contacts(&Motion::new(query)).instants.is_empty()
}

/// [`Query::contact_times`], computed in integers alone.
#[must_use]
pub fn contact_times<K: Kind>(query: &Query<K>) -> ContactTimes {
    let contacts = contacts(&Motion::new(query));
    let mut times = contacts.instants.iter().map(Instant::round);
    match times.next() {
        Some(first) if contacts.lasting => ContactTimes::Interval { first },
        first => ContactTimes::Finite(Times(first.into_iter().chain(times).collect())),
    }
}

/// [`Query::time_of_impact`], computed in integers alone.
#[must_use]
pub fn time_of_impact<K: Kind>(query: &Query<K>) -> Option<f64> {
    contact_times(query).first().map(ContactTime::lower)
}

/// The instants of contact among the ends of the step and the events in it.
struct Contacts {
    instants: Vec<Instant>,
    /// Whether there is contact between two of them, and so in a whole interval.
    lasting: bool,
}

fn contacts<K: Kind>(motion: &Motion<K>) -> Contacts {
    let mut instants = instant::roots(&motion.events());
    let between = |pair: &[Instant]| motion.touches(&Instant::Dyadic(pair[0].before(&pair[1])));
    let lasting = motion.volume.is_zero() && instants.windows(2).any(between);
    instants.retain(|instant| motion.touches(instant));
    Contacts { instants, lasting }
}
