//! The direction of a Newton iteration, and how far it is followed.

use nalgebra::Vector3;

/// The largest step size relative to the free part of a step. The barrier is infinite at contact.
pub(super) const SLACK: f64 = 0.9;

/// The largest displacement of a vertex in one iteration, relative to the extent of the scene. A larger one
/// would sweep over too many pairs, and is far from the minimum.
pub(super) const FARTHEST: f64 = 0.25;

/// The Newton direction at an iterate.
pub(super) struct Direction<'a> {
    /// The displacement of each vertex.
    pub(super) displacements: &'a [Vector3<f64>],
    /// The largest component of a displacement.
    pub(super) size: f64,
    /// The gradient of the potential.
    pub(super) gradient: &'a [Vector3<f64>],
    /// Twice the decrease of the potential that the quadratic model predicts for the whole direction.
    pub(super) decrease: f64,
}

impl Direction<'_> {
    /// The slope of the potential along displacements.
    pub(super) fn slope(&self, displacements: &[Vector3<f64>]) -> f64 {
        dot(self.gradient, displacements)
    }

    /// The length of displacements, relative to the length of the direction.
    pub(super) fn share(&self, displacements: &[Vector3<f64>]) -> f64 {
        let square = |vectors| dot(vectors, vectors);
        (square(displacements) / square(self.displacements)).sqrt()
    }
}

/// The product of two vectors of all vertices.
pub(super) fn dot(a: &[Vector3<f64>], b: &[Vector3<f64>]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
}
