//! Floating-point filters: each one proves an answer or returns that it is unknown.
//!
//! [`screening`] is the ladder of the filters, [`contact`] continues from it to times and impacts,
//! [`roundoff`] has the conventions of the error bounds. Each bound is derived beside its code.

mod alongside;
mod coincident;
mod contact;
mod coplanarity;
mod cubic;
mod double_double;
mod fixed_width;
mod hull;
mod impact;
mod lattice;
mod moment;
mod number;
mod planar;
mod position;
mod precise_cubic;
mod roundoff;
mod screening;
mod vector;
mod wide;

pub(crate) use contact::Contact;
pub(crate) use coplanarity::Coplanarity;
pub(crate) use cubic::Cubic;
pub(crate) use double_double::{DoubleDouble, ROUNDOFF};
pub(crate) use hull::{Hull, diagonal_separates};
pub(crate) use number::{Lanes, Number, Points, subtract};
pub(crate) use roundoff::{LARGEST, UNDERFLOW, UNIT, certain_sign};
pub(crate) use screening::{Decision, Screened, decide, decide_near_plane, screen_planes};
pub(crate) use vector::{add, cross, dot, minus, scaled, select, towards};
