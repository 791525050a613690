//! The definition: contact decided in integers, without rounding and without tolerance.
//!
//! Coordinates are dyadic rationals, so that a query is a set of integer polynomials in t. Contact
//! begins and ends at roots of one of them (the four points become coplanar, or, if they
//! always are, a vertex reaches an edge), and the signs of others at a root decide contact there. The squared
//! distance is the least of those of the primitives' features, each a quotient of polynomials: the times
//! within a distance begin and end where one of them reaches its square (`docs/separation.md`).
//! Every answer of this crate is the one defined here. Coordinates are read as bit patterns: nothing here
//! depends on the floating-point environment.
//!
//! # Tangency
//!
//! Where primitives graze, the polynomial of the events has a root at which its sign does not change.
//! `divisor.rs`, `square_free`, makes it a simple one, `roots.rs` finds it, and the signs of the other
//! polynomials there decide, as at any root: `motion.rs`, `touches`, for contact, and `nearness/feature.rs`
//! within a distance.

mod approximation;
mod bodies;
mod bracket;
mod displacement;
mod divisor;
mod dyadic;
mod evaluation;
mod expansion;
mod first;
mod first_contact;
mod frame;
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
mod quaternion;
mod ratio;
mod roots;
mod split;
mod turn;

pub(crate) use dyadic::{parts, to_integers};
pub(crate) use first::First;
pub(crate) use first_contact::FirstContact;
#[cfg(test)]
pub(crate) use nearness::FirstWithin;
pub(crate) use nearness::distance_at;
pub(crate) use points::MovingPoints;
#[cfg(test)]
pub(crate) use polynomial::Polynomial;
#[cfg(test)]
pub(crate) use roots::roots;
pub(crate) use turn::{Turn, cosine_sign, vanishes};
