//! Predicates of an edge and a face at rest, compared with rational arithmetic.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod named_cases;
mod oracle;
mod random;
