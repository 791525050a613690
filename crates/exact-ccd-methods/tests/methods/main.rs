//! The guarantees of all methods, and the known errors of each.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod bernstein;
mod guarantees;
mod inclusion;
mod root_finding;
