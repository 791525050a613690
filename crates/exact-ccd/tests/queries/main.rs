//! The answers to queries, compared with their definition, their symmetries, and independent truth.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod agreement;
mod batch;
#[path = "../oracle/check.rs"]
#[allow(dead_code, reason = "other tests need more of it")]
mod check;
mod cuts;
#[path = "../oracle/definition/mod.rs"]
mod definition;
mod generators;
mod invariance;
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
