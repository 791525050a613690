//! Checks certificates about triangle meshes in motion, with rods and points.
//!
//! Vertices move in straight lines from one frame to the next. A certificate proves, for each such
//! step, one or more of these statements:
//!
//! 1. No edge pierces a face at t = 0 ([`separation`], the rows of [`Kind::EdgeFace`]).
//! 2. No two primitives that count come into contact, or within a distance d, at any time of [0, T]
//!    ([`separation`]). [`mesh`] defines the pairs that count. Of a vertex and an edge that an edge connects,
//!    only contact is excluded, whatever d is.
//! 3. Two named primitives are in contact, or within d, at a time after T and not after T⁺, where T and
//!    T⁺ are adjacent f64 ([`contact`]). With the second statement, the earliest contact of the step is in
//!    this interval; another pair may be the first in it. Without it, T⁺ is 0, and they touch at t = 0.
//!
//! Coordinates are f64, so they are integers times a power of two, and every decision is made in
//! integers. The checker finds the pairs that need a proof itself ([`tree`]), so that a certificate
//! cannot leave one out. Nothing here depends on the programs that make certificates.
//!
//! The order of reading: [`mesh`] has the pairs that count, [`motion`] the positions, [`separation`] and
//! [`contact`] the proofs, [`tree`] and [`grid`] the search for all pairs, [`certificate`] the bytes,
//! [`check`](mod@check) the statements, [`ply`] the mesh files.

pub mod bytes;
pub mod certificate;
pub mod check;
pub mod contact;
pub mod failure;
pub mod grid;
pub mod mesh;
pub mod motion;
pub mod ply;
pub mod polynomial;
pub mod separation;
pub mod tree;

pub use check::check;
pub use failure::Failure;
pub use mesh::{Kind, Mesh, Pair};
