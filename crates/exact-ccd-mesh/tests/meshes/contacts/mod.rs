//! Candidates, detectors and free steps against loops over all pairs.

mod bisection;
mod can_collide;
mod candidates;
mod clearances;
mod distance;
pub(crate) mod every_pair;
mod free_step;
mod free_steps;
mod held_back;
mod points;
pub(crate) mod scene;
mod single_precision;
mod start_check;
mod within;
