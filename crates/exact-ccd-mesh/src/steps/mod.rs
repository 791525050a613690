//! Meshes in motion: the validated step from positions to positions, the motion from frame to frame, the
//! welding of vertices that coincide throughout a motion, and the rotation between two frames.

mod motion;
mod rigid_fit;
mod step;
mod weld;

pub use motion::{Motion, MotionError};
pub use rigid_fit::RigidFit;
pub use step::{Step, StepError};
pub use weld::Welding;

pub(crate) use step::place;
