//! The lines of the answer, one for the scene and one for each time step, as text or JSON.

pub(super) mod convergence;
pub(super) mod json;
pub(super) mod significant;
pub(super) mod text;
