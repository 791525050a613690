//! Continuous collision detection that is right.
//!
//! Two primitives of moving triangle meshes, a vertex and a face ([`VertexFace`]) or two edges
//! ([`EdgeEdge`]), move in straight lines from t = 0 to t = 1. Do they touch, how often, and when first?
//! For every finite input, without rounding it, this crate
//!
//! - decides contact: [`Query::collides`], with no false positive and no false negative;
//! - counts the contacts: [`Query::contact_times`];
//! - returns the time of impact, correctly rounded down: [`Query::time_of_impact`];
//! - finds when they come within a distance: [`Query::intervals_within`], see [`separation`];
//! - and says what a solver needs to know about the earliest contact: [`Query::impact`].
//!
//! ```
//! use exact_ccd::{Query, VertexFace};
//!
//! // A vertex falls through a resting triangle.
//! let query = Query::<VertexFace>::new(
//!     [[0.25, 0.25, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
//!     [[0.25, 0.25, -2.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
//! )?;
//! assert!(query.collides());
//! // t = 1/3 is no f64: this is the largest f64 below it, and [0, toi) is free of contact for certain.
//! assert_eq!(query.time_of_impact(), Some(0.3333333333333333));
//! # Ok::<(), exact_ccd::NonFinite>(())
//! ```
//!
//! For a mesh at rest, [`predicates::EdgeFace::intersects`] tells whether an edge meets a face, as exactly.
//!
//! *Contact* is a common point of the closed primitives at a time of the closed step: touching counts, at
//! t = 0 and t = 1 too. The integers of [`exact`] define every answer; floating-point filters answer first
//! where their error bounds prove the same.
#![no_std]

#[cfg(all(target_arch = "x86", not(target_feature = "sse2")))]
compile_error!("the error bounds of the filters need f64 arithmetic without excess precision: enable SSE2");

extern crate alloc;

pub mod batch;
mod ccd;
mod contact;
pub mod exact;
mod filter;
mod impact;
mod kind;
pub mod parity;
pub mod predicates;
mod query;
pub mod separation;
mod time;

pub use ccd::{Ccd, Decide, Exact, Guarantees, TimeGuarantee};
pub use contact::Stage;
pub use impact::Impact;
pub use kind::{EdgeEdge, Kind, VertexEdge, VertexFace, VertexVertex};
pub use query::{NonFinite, Point, Query};
pub use time::{ContactTime, ContactTimes, Times};
