//! Floating-point filters: each one proves an answer or returns that it is unknown.
//!
//! [`screening`] is the ladder of the filters. Its last stages are in [`near_plane`] for contact, and in
//! [`nearness`] for a separation above 0. [`contact`] continues to times and impacts, [`roundoff`] has the
//! conventions of the error bounds. Each bound is derived beside its code.

mod alongside;
mod coincident;
mod contact;
mod coplanarity;
mod cubic;
mod decision;
mod double_double;
mod dyadic;
mod exact_cubic;
mod factors;
mod fixed_width;
mod fraction;
mod gap;
mod hull;
mod impact;
mod lattice;
mod length;
mod moment;
mod near_plane;
mod nearness;
mod number;
mod planar;
mod position;
mod precise_cubic;
#[cfg(test)]
mod proof;
mod roundoff;
mod screening;
#[cfg(test)]
mod statements;
mod vector;
mod wide;
mod window;
mod zeros;

pub(crate) use contact::Contact;
pub(crate) use cubic::Cubic;
pub(crate) use decision::{Decision, Proved};

pub(crate) use gap::{Gap, Touching, Within};
pub(crate) use hull::{Hull, diagonal_limit};
pub(crate) use near_plane::decide_near_plane;
pub(crate) use nearness::{LEAST_UNTIL, free_until, impact as impact_within, intervals as intervals_within};
pub(crate) use number::{Lanes, Points};
pub(crate) use roundoff::{UNIT, certain_sign, margin};
pub(crate) use screening::{Screened, decide, decide_between, screen_planes};
pub(crate) use vector::{cross, cross_magnitude, dot, minus};
