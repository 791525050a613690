//! Meshes in motion: the validated step from positions to positions, the motion from frame to frame, and the
//! welding of vertices that coincide throughout a motion.

mod motion;
mod step;
mod weld;

pub use motion::{Motion, MotionError};
pub use step::{Step, StepError};
pub use weld::Welding;
