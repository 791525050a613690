//! The arguments, the half spaces, the files and the report of `step` and `audit`, the commands about a mesh
//! in motion.

pub(crate) mod arguments;
mod body_pairs;
pub(crate) mod counts;
pub(crate) mod half_spaces;
pub(crate) mod paraview;
pub(crate) mod report;
