//! The answers to queries, against their definition, their symmetries, and independent truth.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod agreement;
mod constructed;
mod cuts;
mod generators;
mod invariance;
mod laws;
mod named_cases;
mod non_finite;
mod primitives;
mod radicals;
mod rational;
mod rational_times;
mod runner;
mod subdivision;
mod symmetry;
