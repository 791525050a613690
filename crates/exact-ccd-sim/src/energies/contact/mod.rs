//! Contact: the broad phase, the constraint set and the barrier.

mod barrier;
mod collision;
mod collision_set;
mod stiffness;
mod surface;
mod weights;

pub(crate) use barrier::Barrier;
pub(crate) use collision::Collision;
pub(crate) use collision_set::CollisionSet;
pub(crate) use stiffness::StiffnessRange;
pub(crate) use surface::Surface;
pub(crate) use weights::{Part, Weights};
