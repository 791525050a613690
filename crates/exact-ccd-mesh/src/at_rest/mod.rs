//! Meshes at rest: the places where a mesh passes through itself, and the check that it does not where a step
//! begins.

mod intersections;
mod start_check;

pub use intersections::{Intersection, IntersectionOptions, IntersectionsError, Meeting, intersections};

pub(crate) use start_check::StartCheck;
