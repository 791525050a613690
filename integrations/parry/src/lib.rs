//! Exact shape casts of meshes for [parry](https://parry.rs) and Rapier.
//!
//! An `ExactDispatcher` is a dispatcher of queries for surfaces: `TriMesh`, `Polyline`, `Triangle` and
//! `Segment`. It decides exactly whether two of them meet, and when a motion brings them together. All other
//! shapes and queries are `Unsupported`, so that it is the first of a chain:
//!
//! ```
//! use exact_ccd_parry::f32::ExactDispatcher;
//! use parry3d::math::{Pose, Vector};
//! use parry3d::query::{DefaultQueryDispatcher, QueryDispatcher, ShapeCastOptions};
//! use parry3d::shape::Triangle;
//!
//! let dispatcher = ExactDispatcher.chain(DefaultQueryDispatcher);
//! let floor = Triangle::new(Vector::ZERO, Vector::new(8.0, 0.0, 0.0), Vector::new(0.0, 8.0, 0.0));
//! let pose = Pose::translation(1.0, 1.0, 3.0);
//! let options = ShapeCastOptions::default();
//! let down = Vector::new(0.0, 0.0, -2.0);
//! let hit = dispatcher.cast_shapes(&pose, down, &floor, &floor, options)?.expect("it falls onto the floor");
//! assert_eq!(hit.time_of_impact, 1.5);
//! # Ok::<(), parry3d::query::Unsupported>(())
//! ```
//!
//! | query | answer |
//! |---|---|
//! | `intersection_test` | exact: true if the surfaces have a common point |
//! | `cast_shapes` | the earliest contact, exact for the positions as below; the time is rounded down |
//! | `cast_shapes_nonlinear` | certified: the surfaces are apart before the time of the hit |
//! | all others | `Unsupported` |
//!
//! # Positions
//!
//! parry computes the positions of the second shape at the start: pose times vertex, rounded to its numbers.
//! The ends are these plus velocity times duration, rounded to f64. Each vertex moves in a straight line
//! from its start to its end, and the answer is exact for that motion.
//!
//! # Surfaces
//!
//! A mesh inside another one does not meet it. A hit at time 0 has the status
//! `PenetratingOrWithinTargetDist`. The normals are zero if surfaces pass through each other at the start or
//! rest on each other, and if edges slide along each other.
//!
//! `stop_at_penetration: false` is `Unsupported`: a surface has no inside, from which to tell the motion that
//! leaves a contact from the motion that passes through.

#![cfg_attr(
    all(feature = "f32", feature = "f64"),
    expect(clippy::duplicate_mod, reason = "one source for both precisions")
)]

mod motion;
mod surfaces;

#[cfg(feature = "f32")]
#[path = "."]
pub mod f32 {
    //! For `parry3d`.
    use parry3d as parry;
    type Real = f32;

    mod dispatcher;
    pub use dispatcher::ExactDispatcher;
}

#[cfg(feature = "f64")]
#[path = "."]
pub mod f64 {
    //! For `parry3d-f64`.
    use parry3d_f64 as parry;
    type Real = f64;

    #[expect(clippy::useless_conversion, reason = "numbers of f32 are converted")]
    mod dispatcher;
    pub use dispatcher::ExactDispatcher;
}

/// The examples in the README of this crate, as tests.
#[cfg(all(doctest, feature = "f32"))]
#[doc = include_str!("../README.md")]
struct Readme;
