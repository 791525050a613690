//! Meshes at rest: the places where a mesh meets itself, the components inside of closed ones, and the check
//! that nothing crosses where a step begins.

mod enclosed;
mod intersections;
mod start_check;

pub use enclosed::{Enclosed, enclosed};
pub use intersections::{
    Intersection, IntersectionOptions, IntersectionsError, Meeting, has_intersections, intersections,
};

pub(crate) use start_check::StartCheck;
