//! Root parity, compared with the definition of contact and with the same method in integers; its
//! rounding, compared with exact arithmetic.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod any_magnitude;
mod brochu;
mod check;
mod corners;
mod definition;
mod displacement;
mod expected;
mod flat_patch;
mod laws;
mod plane;
mod rays;

#[path = "../../../exact-ccd/tests/queries/generators/mod.rs"]
#[expect(
    dead_code,
    unused_imports,
    reason = "the tests of queries use more of the families"
)]
mod generators;
#[path = "../../../exact-ccd/tests/queries/primitives.rs"]
#[expect(dead_code, reason = "what the families are made of, and more")]
mod primitives;
#[path = "../../../exact-ccd/tests/queries/runner.rs"]
mod runner;
