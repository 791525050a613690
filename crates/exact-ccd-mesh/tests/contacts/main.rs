//! Candidates, detectors and free steps against loops over all pairs.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod bisection;
mod can_collide;
mod candidates;
mod distance;
mod free_step;
mod free_steps;
mod scene;
mod start_check;
mod within;

#[path = "../odd/mod.rs"]
mod odd;
