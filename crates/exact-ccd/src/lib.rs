//! Exact continuous collision detection.
//!
//! Two primitives of moving triangle meshes, a vertex and a face ([`VertexFace`]) or two edges
//! ([`EdgeEdge`]), move in straight lines from t = 0 to t = 1. For every finite input, without
//! rounding it, this crate
//!
//! - decides whether they touch: [`Query::collides`], without false positives or false negatives;
//! - computes the time of impact, correctly rounded down: [`Query::time_of_impact`];
//! - finds all times of contact, as maximal closed intervals: [`Query::intervals`];
//! - computes the parameters and the normal of the earliest contact: [`Query::impact`].
//!
//! Contact is the distance 0. With a [`Separation`] d in place of [`CONTACT`], all of this is about a
//! distance of at most d, in the same sense.
//!
//! ```
//! use exact_ccd::{CONTACT, Query, Separation, VertexFace};
//!
//! // A vertex falls through a resting triangle.
//! let query = Query::<VertexFace>::new(
//!     [[0.25, 0.25, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
//!     [[0.25, 0.25, -2.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
//! )?;
//! assert!(query.collides(CONTACT));
//! // t = 1/3 is not an f64: this is the largest f64 below it, and [0, toi) is certainly free of contact.
//! assert_eq!(query.time_of_impact(CONTACT), Some(0.3333333333333333));
//! assert_eq!(query.intervals(CONTACT).count(), Some(1));
//!
//! let within = query.intervals(Separation::new(0.25)?);
//! assert_eq!((within[0].start.lower(), within[0].end.upper()), (0.25, 0.4166666666666667));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! *Contact* is a common point of the closed primitives at a time of the closed step: touching
//! counts, at t = 0 and t = 1 too. Integers define every answer; floating-point
//! filters answer first where their error bounds prove the same.
//!
//! | item | contents |
//! |---|---|
//! | [`Query`] | one query and its answers |
//! | [`Options`] | the distance at which primitives touch, and the last time that counts |
//! | [`Collision`] | a query that collides; times and impact continue from the decision |
//! | [`motion`] | queries of points on curves and of rigid bodies, decided in integers |
//! | [`batch`] | many queries at a time, by vector instructions |
//! | [`predicates`] | orientation and intersection of points at rest |
//! | [`AnyKind`], [`with_kind!`] | the list of the kinds, for one that is known at run time |
//! | [`Ccd`] | the trait of collision detection methods, and the exact one |
//! | [`Exactly`] | the definition in integers, without filters |
//!
//! # Features
//!
//! - `std` (default): the vector instructions of x86 processors are detected at run time. Without
//!   it, the crate is `no_std`, needs `alloc` only, and uses the instructions that the program is
//!   compiled for.
//!
//! # Floating-point environment
//!
//! A thread that rounds in another direction than to nearest, as in interval arithmetic, or flushes
//! subnormal numbers to zero (FTZ, DAZ), as in a program linked with `-ffast-math`, gets the same decisions,
//! counts and times: this is [detected](environment::is_default) on the thread that computes, for each query
//! or batch and each answer of a [`Collision`], and the exact path decides then, which is much slower. The
//! exact path gives the parameters of an impact too, rounded down; the components of a normal are rounded as
//! the thread rounds.
//!
//! # Panics
//!
//! No function panics on any input.
#![no_std]

#[cfg(all(target_arch = "x86", not(target_feature = "sse2")))]
compile_error!("the error bounds of the filters need f64 arithmetic without excess precision: enable SSE2");

extern crate alloc;
#[cfg(test)]
extern crate std;

mod answers;
pub mod batch;
mod ccd;
mod collision;
mod decide;
mod decided;
pub mod environment;
mod exact;
mod exactly;
mod filter;
mod fixed;
mod gradient;
mod kind;
pub mod motion;
mod numbers;
pub mod predicates;
mod query;
mod tables;
mod values;
mod vectors;
mod weights;

pub use ccd::{Ccd, Decide, Exact, Guarantees, TimeGuarantee};
pub use collision::Collision;
pub use exactly::Exactly;
pub use gradient::{Gradient, NotDifferentiable};
pub use kind::{AnyKind, Kind};
pub use query::{NonFinite, Query};
pub use tables::{EdgeEdge, Point, VertexEdge, VertexFace, VertexVertex};
pub use values::{
    Axis, CONTACT, ContactTime, DistanceBounds, Impact, Interval, Intervals, InvalidSeparation,
    InvalidThickness, Options, Separation, Separations, Stage, Thickness, TimeOutOfStep,
};
