//! Meshes in motion, as positions and faces: each crate makes its own types of them.

pub mod cloth;
pub mod drape;
pub mod flat;
pub mod general;
