//! Candidates, detectors and free steps against loops over all pairs.

mod bisection;
mod can_collide;
mod candidates;
mod distance;
mod free_step;
mod scene;
mod start_check;
mod within;
