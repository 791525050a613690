//! An edge and a face at rest, against rational numbers.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod named_cases;
mod oracle;
mod random;
