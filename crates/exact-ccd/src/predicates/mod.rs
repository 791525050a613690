//! Exact predicates of points at rest: orientation and intersection.

mod edge_face;
mod orient3d;

pub use edge_face::EdgeFace;
pub use orient3d::orient3d;
