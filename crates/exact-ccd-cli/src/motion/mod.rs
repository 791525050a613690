//! The commands about a mesh in motion, `step` and `audit`, have the same arguments, half spaces, files and report.

pub(crate) mod arguments;
pub(crate) mod half_spaces;
pub(crate) mod paraview;
pub(crate) mod report;
