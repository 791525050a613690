//! Candidates, detectors and free steps against loops over all pairs.

mod bisection;
mod can_collide;
mod candidates;
mod clearances;
mod distance;
mod every_pair;
mod free_step;
mod free_steps;
mod held_back;
mod points;
mod scene;
mod start_check;
mod within;
