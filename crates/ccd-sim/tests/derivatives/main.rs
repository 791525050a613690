//! Gradients and Hessians of all energies against finite differences, and that projected Hessians are semi-definite.

mod collisions;
mod contact;
mod differences;
mod distance;
mod elasticity;
mod friction;
