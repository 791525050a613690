//! The friction potential of one contact.

use arrayvec::ArrayVec;
use nalgebra::{Matrix2, Matrix3x2, Vector2, Vector3};

use super::smooth::Smoothing;
use crate::distance::Separation;
use crate::element::{Element, Matrix12, Vector12};

/// The friction of one contact, with lagged normal force and tangent plane.
///
/// Source: *Incremental Potential Contact*, section 5.3.
#[derive(Clone, Debug)]
pub struct FrictionContact {
    vertices: ArrayVec<u32, 4>,
    /// The weights of the vertices in the vector between the closest points.
    weights: [f64; 4],
    /// An orthonormal basis of the tangent plane.
    tangents: Matrix3x2<f64>,
    /// μ λ: the friction coefficient times the normal force, in units of the potential per m.
    bound: f64,
}

impl FrictionContact {
    /// The friction at a separation. `bound` is the friction coefficient times the normal force. It is
    /// negative for a term that corrects others; its Hessian counts as zero then.
    #[must_use]
    pub fn new(vertices: ArrayVec<u32, 4>, separation: &Separation, bound: f64) -> Self {
        Self {
            vertices,
            weights: separation.weights,
            tangents: tangents(&separation.vector),
            bound,
        }
    }

    /// The vertices.
    #[must_use]
    pub fn vertices(&self) -> &ArrayVec<u32, 4> {
        &self.vertices
    }

    /// The potential, for the displacements of the vertices since the start of the step.
    #[must_use]
    pub fn value(&self, displacements: &[Vector3<f64>; 4], smoothing: Smoothing) -> f64 {
        self.bound * smoothing.potential(self.slip(displacements).norm())
    }

    /// The work of the force against the slip since the start of the step: μ λ f₁(y) y.
    #[must_use]
    pub fn work(&self, displacements: &[Vector3<f64>; 4], smoothing: Smoothing) -> f64 {
        let slip = self.slip(displacements).norm();
        self.bound * smoothing.force_over_slip(slip) * slip * slip
    }

    /// The gradient and the Hessian of the potential. The Hessian is positive semi-definite.
    #[must_use]
    pub fn derivatives(&self, displacements: &[Vector3<f64>; 4], smoothing: Smoothing) -> Element {
        let slip = self.slip(displacements);
        let size = slip.norm();
        let ratio = smoothing.force_over_slip(size);
        let force = self.tangents * slip * (self.bound * ratio);
        // The second derivative is f₁′ along the slip and f₁ / y across it.
        let direction = slip.try_normalize(0.0).unwrap_or_else(Vector2::zeros);
        let along = direction * direction.transpose() * (smoothing.stiffness(size) - ratio);
        let plane = (Matrix2::identity() * ratio + along) * self.bound.max(0.0);
        let block = self.tangents * plane * self.tangents.transpose();
        Element {
            vertices: self.vertices.clone(),
            gradient: Vector12::from_fn(|row, _| self.weights[row / 3] * force[row % 3]),
            hessian: Matrix12::from_fn(|row, column| {
                self.weights[row / 3] * self.weights[column / 3] * block[(row % 3, column % 3)]
            }),
        }
    }

    /// The relative displacement in the tangent plane.
    fn slip(&self, displacements: &[Vector3<f64>; 4]) -> Vector2<f64> {
        let pairs = displacements.iter().zip(&self.weights);
        let relative: Vector3<f64> = pairs.map(|(displacement, weight)| displacement * *weight).sum();
        self.tangents.tr_mul(&relative)
    }
}

/// Two unit vectors that are orthogonal to each other and to the normal.
fn tangents(normal: &Vector3<f64>) -> Matrix3x2<f64> {
    let axis = Vector3::ith(normal.iamin(), 1.0);
    let first = normal.cross(&axis).try_normalize(0.0).unwrap_or_else(Vector3::x);
    let second = normal.cross(&first).try_normalize(0.0).unwrap_or_else(Vector3::y);
    Matrix3x2::from_columns(&[first, second])
}
