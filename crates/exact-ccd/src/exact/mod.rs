//! The definition: contact decided in integers, without rounding and without tolerance.
//!
//! Coordinates are dyadic rationals, so that a query is a set of integer polynomials in t. Contact
//! begins and ends at roots of one of them ([`Query`]'s four points become coplanar, or, if they
//! always are, a vertex reaches an edge), and the signs of others at a root decide contact there.
//! Every answer of this crate is the one defined here. The functions below compute it without any
//! filter, for audits. They read coordinates as bit patterns, and do not depend on the
//! floating-point environment.

mod approximation;
mod bracket;
mod divisor;
mod dyadic;
mod evaluation;
mod first_contact;
mod gap;
mod guess;
mod impact;
mod instant;
mod interval_sign;
mod modular;
mod motion;
mod narrowing;
mod order;
mod polynomial;
mod ratio;
mod roots;
pub mod separation;
mod split;

pub(crate) use dyadic::{decompose, to_integers};
pub(crate) use first_contact::FirstContact;
pub(crate) use motion::{Vector, cross, dot};
pub(crate) use polynomial::Polynomial;
pub(crate) use roots::roots;

use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::time::ContactTimes;

/// [`Query::collides`], decided in integers alone.
#[must_use]
pub fn collides<K: Kind>(query: &Query<K>) -> bool {
    FirstContact::of(query).is_some()
}

/// [`Query::contact_times`], computed in integers alone.
#[must_use]
pub fn contact_times<K: Kind>(query: &Query<K>) -> ContactTimes {
    FirstContact::of(query).map_or(ContactTimes::NONE, |first| first.times())
}

/// [`Query::time_of_impact`], computed in integers alone.
#[must_use]
pub fn time_of_impact<K: Kind>(query: &Query<K>) -> Option<f64> {
    FirstContact::of(query).map(|first| first.time().lower())
}

/// [`Query::impact`], computed in integers alone.
#[must_use]
pub fn impact<K: Kind>(query: &Query<K>) -> Option<Impact> {
    FirstContact::of(query).map(|first| first.impact())
}
