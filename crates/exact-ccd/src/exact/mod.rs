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
pub(crate) use first_contact::FirstContact;
pub(crate) use nearness::FirstWithin;
pub use nearness::distance_at;
#[cfg(test)]
pub(crate) use polynomial::Polynomial;
#[cfg(test)]
pub(crate) use roots::roots;

use crate::collision::Collision;
use crate::filter::Decision;
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
        collision(query, options).is_some()
    }
}

/// [`Query::time_of_impact`], computed in integers alone.
#[must_use]
pub fn time_of_impact<K: Kind>(query: &Query<K>, options: impl Into<Options>) -> Option<f64> {
    collision(query, options.into()).map(|collision| collision.time_of_impact())
}

/// [`Query::intervals`], computed in integers alone.
#[must_use]
pub fn intervals<K: Kind>(query: &Query<K>, options: impl Into<Options>) -> Intervals {
    collision(query, options.into()).map_or_else(Intervals::default, |collision| collision.intervals())
}

/// [`Query::impact`], computed in integers alone.
#[must_use]
pub fn impact<K: Kind>(query: &Query<K>, options: impl Into<Options>) -> Option<Impact> {
    collision(query, options.into()).map(|collision| collision.impact())
}

/// The collision of a query, without filters: all its answers are computed in integers.
fn collision<K: Kind>(query: &Query<K>, options: Options) -> Option<Collision<'_, K>> {
    let collision = Collision::from_decision(query, options.separation, Decision::Unknown).ok()?;
    collision.until(options.until)
}
