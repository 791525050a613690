//! The bounds of the filters, checked by a machine: the very code of the filters runs on [`Symbol`]s, which
//! count roundings, degrees and magnitudes.
//!
//! `docs/proof.md` lists all bounds, and the check of each.

mod gappa;
mod roundings;
mod symbol;

pub(super) use gappa::Script;
pub(super) use roundings::{assert_bound, assert_counts, opposite_points, power, symbols};
pub(super) use symbol::{Precise, Symbol};
