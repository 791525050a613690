//! The answers to queries, compared with their definition, their symmetries, and independent truth.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod agreement;
mod batch;
#[path = "../oracle/check.rs"]
mod check;
mod cuts;
#[path = "../oracle/definition/mod.rs"]
mod definition;
mod each_kind;
mod families;
mod generators;
mod invariance;
mod kinds;
mod known_contacts;
mod laws;
mod named_cases;
mod non_finite;
mod primitives;
mod radicals;
mod rational;
mod rational_times;
mod runner;
mod separated;
mod subdivision;
mod symmetry;
mod until;
mod within;
