//! Queries within a distance, against their definition, their symmetries, and independent truth.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod agreement;
mod batch;
#[path = "../oracle/check.rs"]
mod check;
mod defined;
#[path = "../oracle/definition/mod.rs"]
mod definition;
mod distance;
mod families;
#[path = "../queries/generators/mod.rs"]
#[allow(dead_code, unused_imports, reason = "the tests of contact need more of it")]
mod generators;
mod impact;
mod invariance;
mod kinds;
mod laws;
mod monotone;
mod named_cases;
#[path = "../queries/primitives.rs"]
#[allow(dead_code, reason = "the tests of contact need more of it")]
mod primitives;
#[path = "../queries/runner.rs"]
mod runner;
mod shorter_edges;
mod thickness;
mod zero;
