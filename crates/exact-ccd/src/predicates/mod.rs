//! Exact predicates of points at rest: orientation and intersection.

mod determinant;
mod edge_face;
mod orient3d;

pub(crate) use determinant::{Integers, determinant, integers, permanent, sign_of_determinant, volume};
pub use edge_face::EdgeFace;
pub use orient3d::orient3d;
