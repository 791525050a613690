//! Gradients and Hessians of all energies against finite differences. Projected Hessians are semi-definite.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod collisions;
mod contact;
mod differences;
mod distance;
mod elasticity;
mod friction;
mod naive;
mod rods;
mod shells;
mod thickness;
