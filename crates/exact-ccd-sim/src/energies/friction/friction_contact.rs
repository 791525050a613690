//! The friction potential of one contact.

use arrayvec::ArrayVec;
use exact_ccd_mesh::Point;
use nalgebra::{Matrix2, Matrix3x2, Vector2, Vector3};

use super::smooth::Smoothing;
use crate::energies::distance::ShortestVector;
use crate::energies::term::{Block, Energy, Projection, gather_some, write_products};

/// The friction of one contact, with lagged normal force and tangent plane.
///
/// Source: *Incremental Potential Contact*, section 5.3.
#[derive(Clone, Debug)]
pub(crate) struct FrictionContact {
    vertices: ArrayVec<u32, 4>,
    /// The positions of the vertices without slip.
    origin: [Vector3<f64>; 4],
    /// The weights of the vertices in the vector between the closest points.
    weights: [f64; 4],
    /// An orthonormal basis of the tangent plane.
    tangents: Matrix3x2<f64>,
    /// μ λ: the friction coefficient times the normal force, in units of the potential per m.
    bound: f64,
    smoothing: Smoothing,
}

impl FrictionContact {
    /// The friction at a shortest. `origin` has the positions of all vertices without slip. `bound` is the
    /// friction coefficient times the normal force. It is negative for a term that corrects others; its
    /// Hessian counts as zero then.
    pub(crate) fn new(
        vertices: ArrayVec<u32, 4>,
        origin: &[Point],
        shortest: &ShortestVector,
        bound: f64,
        smoothing: Smoothing,
    ) -> Self {
        Self {
            origin: gather_some(origin, &vertices),
            vertices,
            weights: shortest.weights,
            tangents: tangents(&shortest.vector),
            bound,
            smoothing,
        }
    }

    /// The work of the force against the slip: μ λ f₁(y) y.
    pub(crate) fn work(&self, points: &[Point]) -> f64 {
        let slip = self.slip(points).norm();
        self.bound * self.smoothing.force_over_slip(slip) * slip * slip
    }

    /// The relative displacement in the tangent plane.
    fn slip(&self, points: &[Point]) -> Vector2<f64> {
        let now = gather_some(points, &self.vertices);
        let pairs = now.iter().zip(&self.origin).zip(&self.weights);
        let relative: Vector3<f64> = pairs.map(|((now, then), weight)| (now - then) * *weight).sum();
        self.tangents.tr_mul(&relative)
    }
}

impl Energy for FrictionContact {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn value(&self, points: &[Point]) -> f64 {
        self.bound * self.smoothing.potential(self.slip(points).norm())
    }

    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        let slip = self.slip(points);
        let force = self.tangents * slip * (self.bound * self.smoothing.force_over_slip(slip.norm()));
        for (rows, &weight) in gradient.chunks_exact_mut(3).zip(&self.weights) {
            rows.copy_from_slice((force * weight).as_slice());
        }
    }

    /// The second derivative is f₁′ along the slip and f₁ / y across it: it is positive semi-definite.
    fn write_hessian(&self, points: &[Point], _: Projection, hessian: &mut [Block]) {
        let slip = self.slip(points);
        let size = slip.norm();
        let ratio = self.smoothing.force_over_slip(size);
        let direction = slip.try_normalize(0.0).unwrap_or_else(Vector2::zeros);
        let along = direction * direction.transpose() * (self.smoothing.stiffness(size) - ratio);
        let plane = (Matrix2::identity() * ratio + along) * self.bound.max(0.0);
        let block = self.tangents * plane * self.tangents.transpose();
        write_products(&self.weights[..self.vertices.len()], &block, hessian);
    }
}

/// Two unit vectors that are orthogonal to each other and to the normal.
fn tangents(normal: &Vector3<f64>) -> Matrix3x2<f64> {
    let axis = Vector3::ith(normal.iamin(), 1.0);
    let first = normal.cross(&axis).try_normalize(0.0).unwrap_or_else(Vector3::x);
    let second = normal.cross(&first).try_normalize(0.0).unwrap_or_else(Vector3::y);
    Matrix3x2::from_columns(&[first, second])
}
