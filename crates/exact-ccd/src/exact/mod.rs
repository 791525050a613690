//! The definition: contact decided in integers, without rounding and without tolerance.
//!
//! Coordinates are dyadic rationals, so that a query is a set of integer polynomials in t. Contact
//! begins and ends at roots of one of them ([`Query`]'s four points become coplanar, or, if they
//! always are, a vertex reaches an edge), and the signs of others at a root decide contact there. The squared
//! distance is the least of those of the primitives' features, each a quotient of polynomials: the times
//! within a distance begin and end where one of them reaches its square (`docs/separation.md`).
//! Every answer of this crate is the one defined here. The functions below compute it without any
//! filter, for audits. They read coordinates as bit patterns, and do not depend on the
//! floating-point environment.

mod approximation;
mod bracket;
mod divisor;
mod dyadic;
mod evaluation;
mod expansion;
mod first;
mod first_contact;
mod gap;
mod guess;
mod impact;
mod instant;
mod interval_sign;
mod intervals;
mod modular;
mod motion;
mod narrowing;
mod nearness;
mod order;
mod points;
mod polynomial;
mod ratio;
mod roots;
mod split;

pub(crate) use dyadic::{parts, to_integers};
pub(crate) use first::First;
pub(crate) use first_contact::FirstContact;
#[cfg(test)]
pub(crate) use nearness::FirstWithin;
pub(crate) use nearness::distance_at;
#[cfg(test)]
pub(crate) use polynomial::Polynomial;
#[cfg(test)]
pub(crate) use roots::roots;

use crate::impact::Impact;
use crate::interval::Intervals;
use crate::kind::Kind;
use crate::options::Options;
use crate::query::Query;

/// [`Query::collides`], decided in integers alone.
#[must_use]
pub fn collides<K: Kind>(query: &Query<K>, options: impl Into<Options>) -> bool {
    let options = options.into();
    if options.until >= 1.0 && !options.separation.is_zero() {
        nearness::comes_within(query, options.separation)
    } else {
        // Contact, a part of the step, or none of it: NaN.
        first(query, options).is_some()
    }
}

/// [`Query::time_of_impact`], computed in integers alone.
#[must_use]
pub fn time_of_impact<K: Kind>(query: &Query<K>, options: impl Into<Options>) -> Option<f64> {
    first(query, options.into()).map(|first| first.time().lower())
}

/// [`Query::intervals`], computed in integers alone.
#[must_use]
pub fn intervals<K: Kind>(query: &Query<K>, options: impl Into<Options>) -> Intervals {
    first(query, options.into()).map_or_else(Intervals::default, |first| first.intervals())
}

/// [`Query::impact`], computed in integers alone.
#[must_use]
pub fn impact<K: Kind>(query: &Query<K>, options: impl Into<Options>) -> Option<Impact> {
    first(query, options.into()).map(|first| first.impact())
}

/// The first time at which the primitives touch, if it counts.
fn first<K: Kind>(query: &Query<K>, options: Options) -> Option<First<K>> {
    let first = First::of(query, options.separation)?;
    (options.until >= 1.0 || first.time().is_at_most(options.until)).then_some(first)
}
