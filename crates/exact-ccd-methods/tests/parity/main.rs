//! Root parity, compared with the definition of contact and with the same method in integers; its
//! rounding, compared with exact arithmetic.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod any_magnitude;
mod brochu;
mod check;
mod corners;
mod definition;
mod displacement;
mod flat_patch;
mod plane;
mod rays;
