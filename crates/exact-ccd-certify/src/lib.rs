//! Certificates about meshes in motion.
//!
//! `exact-ccd-check` proves them without trusting this crate: it finds all pairs of primitives itself
//! and verifies a witness for each. This crate finds the witnesses. Directions that separate two
//! primitives are guessed in floating point and rounded to small integers; the functions of the checker
//! accept or refuse each. Nothing is written that the checker would refuse.
//!
//! - [`Maker`] adds the steps of a motion one after the other.
//! - [`Uncertified`] counts the pairs for which no witness was found.

mod contact;
mod direction;
mod encode;
mod factor;
mod feature;
mod maker;
mod searched;
mod stretches;

pub use maker::{Maker, MakerError, Uncertified};

/// The example in the README of this crate, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
