//! The answers to queries of straight motion, compared with their definition, laws, and independent truth.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod flat;
mod hard_cases;
mod intersection;
mod oracle;
mod queries;
mod worst_cases;
