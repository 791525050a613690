//! Comparison of methods of continuous collision detection on the same queries.
//!
//! [`comparison`] has the parts: [`Source`](comparison::Source) finds data sets in a folder,
//! [`Comparison`](comparison::Comparison) runs methods and [peers](comparison::Peer) on them, and
//! [`Report`](comparison::Report) writes tables and plots.

pub mod comparison;
