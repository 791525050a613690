//! Contact: the broad phase, the constraint set and the barrier.

mod barrier;
mod collision;
mod collisions;
mod stiffness;
mod surface;
mod weights;

pub use barrier::Barrier;
pub use collision::Collision;
pub use collisions::Collisions;
pub use stiffness::StiffnessRange;
pub use surface::Surface;
pub use weights::{Part, Weights};
