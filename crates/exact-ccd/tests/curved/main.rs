//! Queries of curved motion: answers against the definition, and laws.

mod cases;
#[path = "../oracle/definition/mod.rs"]
#[allow(dead_code, reason = "other test targets need straight motion")]
mod definition;
mod errors;
mod filters;
mod laws;
mod numbers;
mod oracle;
mod places;
