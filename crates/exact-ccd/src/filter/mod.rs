//! Floating-point filters: each one proves an answer or returns that it is unknown.
//!
//! [`screening`] is the ladder of the filters. Its last stages are in [`near_plane`] for contact, and in
//! [`within`] for a separation above 0. [`contact`] continues to times and impacts. [`curved`] is for motion
//! on curves. Each bound is derived beside its code.
//!
//! # Tangency
//!
//! Where primitives graze, no bound proves a sign beside the double root of the cubic: its roots are unknown,
//! and [`near_plane`] asks the integers of fixed width. Within a distance that is only reached, neither side
//! is proved, and the exact path decides.

mod alongside;
mod coincident;
mod contact;
mod coplanarity;
mod curved;
mod decision;
mod gap;
mod hull;
mod impact;
mod near_plane;
mod planar;
mod position;
#[cfg(test)]
mod proof;
mod screening;
#[cfg(test)]
mod statements;
mod within;

pub(crate) use contact::Contact;
pub(crate) use curved::{
    CurvedDecision, Relative, decide_curved, decide_of_bodies, time_of_bodies, time_on_curves,
};
pub(crate) use decision::{Decision, Proved};
pub(crate) use gap::{Gap, Touching, Within};
pub(crate) use hull::{Hull, diagonal_limit};
pub(crate) use near_plane::decide_near_plane;
pub(crate) use screening::{Screened, decide, decide_between, screen_planes};
pub(crate) use within::{LEAST_UNTIL, free_until, impact as impact_within, intervals as intervals_within};
