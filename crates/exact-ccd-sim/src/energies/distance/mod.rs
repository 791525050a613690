//! Squared distances between points, edges and triangles, from their closest features.
//!
//! All pairs of features share one formula. The vector between two points of the features is r = Σ wᵢ xᵢ,
//! with weights that are affine in at most two parameters λ. The squared distance is the minimum of |r|²
//! over λ. By the envelope theorem, its gradient is the gradient of |r|² at fixed λ, and its Hessian is a
//! Schur complement.

mod edge_edge;
mod feature;
mod mollifier;
mod point_edge;
mod point_triangle;

pub(crate) use edge_edge::edge_edge;
pub(crate) use feature::{Factors, Feature, FeatureKind, ShortestVector};
pub(crate) use mollifier::Mollifier;
pub(crate) use point_edge::point_edge;
pub(crate) use point_triangle::point_triangle;

/// A vector with three coordinates for each of four points.
pub(crate) type Vector12 = nalgebra::SVector<f64, 12>;

/// A matrix with a 3 × 3 block for each pair of four points.
pub(crate) type Matrix12 = nalgebra::SMatrix<f64, 12, 12>;
