//! The motions that scripts prescribe: scripts, their vertices, and their targets in one part of a time step.

mod dirichlet;
mod held_chains;
mod motion;
mod paths;
mod times;
mod vertices;

pub(crate) use dirichlet::Dirichlet;
pub(crate) use held_chains::HeldChains;
pub use motion::{KeyFrame, Script};
pub(crate) use paths::Paths;
pub(crate) use times::Times;
pub use vertices::ScriptedVertices;
pub(crate) use vertices::{Axes, Coordinates, Timed};
