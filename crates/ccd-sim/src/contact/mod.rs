//! Contact: which primitives are near, and the barrier between them.

mod barrier;
mod collision;
mod collisions;
mod proximity;
mod stiffness;

pub use barrier::Barrier;
pub use collision::Collision;
pub use collisions::Collisions;
pub use proximity::{Pairs, Surface};
pub use stiffness::StiffnessRange;
