//! What every energy contributes to a Newton step: derivatives with respect to at most four vertices.

use arrayvec::ArrayVec;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// Twelve numbers: three for each of four points.
pub type Vector12 = SVector<f64, 12>;

/// The second derivatives with respect to four points.
pub type Matrix12 = SMatrix<f64, 12, 12>;

/// Gradient and Hessian of one term of the energy, with respect to the vertices on which it depends.
#[derive(Clone, Debug)]
pub struct Element {
    /// The vertices, four at most. The rows behind them are zero.
    pub vertices: ArrayVec<u32, 4>,
    /// The gradient.
    pub gradient: Vector12,
    /// The Hessian, projected to be positive semi-definite.
    pub hessian: Matrix12,
}

impl Element {
    /// The gradient with respect to the vertex at a place in `vertices`.
    #[must_use]
    pub fn force(&self, place: usize) -> Vector3<f64> {
        self.gradient.fixed_rows::<3>(3 * place).into_owned()
    }

    /// The second derivatives with respect to two of the vertices.
    #[must_use]
    pub fn block(&self, row: usize, column: usize) -> Matrix3<f64> {
        self.hessian.fixed_view::<3, 3>(3 * row, 3 * column).into_owned()
    }

    /// The element times a number.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        self.gradient *= factor;
        self.hessian *= factor;
        self
    }
}
