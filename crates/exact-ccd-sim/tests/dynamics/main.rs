//! Properties of simulations: conservation laws, rest, friction, no intersections, reproducibility.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod affine;
mod coils;
mod conservation;
mod contacts;
mod damping;
mod decisions;
mod filters;
mod friction;
mod friction_lags;
mod friction_pairs;
mod half_space;
mod hertz;
mod impact;
mod lengths;
mod line_search;
mod loads;
mod measure;
mod newton;
mod pressing;
mod rest;
mod resume;
mod rod_twist;
mod rods;
mod script_starts;
mod scripted_axes;
mod scripts;
mod shells;
mod springs;
mod start;
mod strain_limit;
mod thick_pairs;
mod thickness;
mod turned;
mod twist;
