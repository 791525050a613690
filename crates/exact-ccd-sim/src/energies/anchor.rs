//! Energies of single vertices.

use exact_ccd_mesh::Point;
use nalgebra::{Matrix3, Vector3};

use super::term::{Block, Energy, Projection, write_blocks, write_rows};

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

    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        let sum = self.offset(points).component_mul(&self.stiffness) - self.force;
        write_rows(&sum, gradient);
    }

    fn write_hessian(&self, _: &[Point], _: Projection, hessian: &mut [Block]) {
        write_blocks(&Matrix3::from_diagonal(&self.stiffness), 1, hessian);
    }
}
