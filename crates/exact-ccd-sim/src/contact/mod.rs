//! Contact: the broad phase, the constraint set and the barrier.

mod apart;
mod barrier;
mod collision;
mod collisions;
mod near_pairs;
mod stiffness;
mod surface;

pub use barrier::Barrier;
pub use collision::Collision;
pub use collisions::Collisions;
pub use near_pairs::NearPairs;
pub use stiffness::StiffnessRange;
pub use surface::Surface;
