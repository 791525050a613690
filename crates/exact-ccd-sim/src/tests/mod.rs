//! Gradients and Hessians of all energies against finite differences, and properties of single terms.

mod carriers;
mod collisions;
mod contact;
mod differences;
mod distance;
mod elasticity;
mod fingerprint;
mod friction;
mod naive;
mod pairs;
mod rods;
mod shells;
mod size;
mod springs;
mod stiffness;
mod strips;
mod thickness;
mod twist;
mod vertex_bend;
