//! Squared distances between points, edges and triangles, by their closest features.
//!
//! All of them are one thing: the vector r = Σ wᵢ xᵢ between the closest points of two features has weights that are
//! affine in at most two parameters λ, and the squared distance is the minimum of |r|² over these. By the envelope
//! theorem its gradient is that of |r|² with λ held fixed, and its Hessian a Schur complement.

mod edge_edge;
mod feature;
mod mollifier;
mod point_triangle;

pub use edge_edge::edge_edge;
pub use feature::{Factors, Feature, FeatureKind, Separation};
pub use mollifier::Mollifier;
pub use point_triangle::point_triangle;
