//! Meshes at rest: the places where a mesh meets itself, and the check that nothing crosses where a step
//! begins.

mod intersections;
mod start_check;

pub use intersections::{
    Intersection, IntersectionOptions, IntersectionsError, Meeting, has_intersections, intersections,
};

pub(crate) use start_check::StartCheck;
