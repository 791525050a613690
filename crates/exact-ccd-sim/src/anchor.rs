//! Energies of single vertices.

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, DVector, Vector3};

use crate::energy::{Energy, Projection};

/// The energy ½ Σ k (x − target)² − force · (x − target) of a vertex, with a sum over the axes: the inertia
/// of a vertex, and the constant forces on it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Anchor {
    pub(crate) vertex: u32,
    pub(crate) target: Point,
    /// k for each axis, in kg.
    pub(crate) stiffness: Vector3<f64>,
    /// In kg m.
    pub(crate) force: Vector3<f64>,
}

impl Anchor {
    fn offset(&self, points: &[Point]) -> Vector3<f64> {
        Vector3::from(points[self.vertex as usize]) - Vector3::from(self.target)
    }
}

impl Energy for Anchor {
    fn vertices(&self) -> &[u32] {
        std::slice::from_ref(&self.vertex)
    }

    fn value(&self, points: &[Point]) -> f64 {
        let offset = self.offset(points);
        offset.dot(&(offset.component_mul(&self.stiffness) * 0.5 - self.force))
    }

    fn gradient(&self, points: &[Point]) -> DVector<f64> {
        let gradient = self.offset(points).component_mul(&self.stiffness) - self.force;
        DVector::from_column_slice(gradient.as_slice())
    }

    fn hessian(&self, _: &[Point], _: Projection) -> DMatrix<f64> {
        DMatrix::from_diagonal(&DVector::from_column_slice(self.stiffness.as_slice()))
    }
}
