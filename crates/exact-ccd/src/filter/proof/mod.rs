//! The bounds of the filters, checked by a machine: the very code of the filters runs on [`Symbol`]s, which
//! count roundings, degrees and magnitudes.
//!
//! `docs/proof.md` lists all bounds, and the check of each.

mod assertions;
mod gappa;
mod half_precision;
mod operators;
mod precise;
mod roundings;
mod symbol;

pub(super) use assertions::{assert_bound, assert_counts, opposite_points, power, symbols};
pub(super) use gappa::Script;
pub(super) use precise::Precise;
pub(super) use symbol::Symbol;
