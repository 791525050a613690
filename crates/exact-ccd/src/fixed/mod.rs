//! Integers of fixed width: exact arithmetic without allocation, and the decision of contact in it.
//!
//! [`decision`] has the answers, by a query in integers ([`lattice`]) and the moments at which its cubic
//! vanishes ([`zeros`]), each in a [`window`] of the step. Every answer is exact, or unknown.
//!
//! # Tangency
//!
//! Where primitives graze, the cubic has a double or triple root. It is certain here if it is a time of few
//! digits, at which the exact value is zero, or a zero of a linear factor ([`factors`]). Roots next to each
//! other are separated by narrow windows ([`zeros`]); other ones are left to the exact path.

mod common_root;
mod coplanar;
mod decision;
mod dyadic;
pub(crate) mod exact_cubic;
mod factors;
mod fraction;
mod lattice;
mod length;
pub(crate) mod moment;
mod quadratic_root;
mod wide;
pub(crate) mod window;
mod zeros;

pub(crate) use decision::{first, first_moment, moments, signs_until, time};
