//! Derivatives of one energy term with respect to at most four vertices, as they enter a Newton step.

use arrayvec::ArrayVec;
use nalgebra::{DMatrix, DVector, Matrix3, SMatrix, SVector, Vector3};

/// A vector with three coordinates for each of four points.
pub type Vector12 = SVector<f64, 12>;

/// A matrix with a 3 × 3 block for each pair of four points.
pub type Matrix12 = SMatrix<f64, 12, 12>;

/// The gradient and the Hessian of one energy term with respect to its vertices.
#[derive(Clone, Debug)]
pub struct Element {
    /// The vertices, at most four. Rows and columns beyond the last vertex are zero.
    pub vertices: ArrayVec<u32, 4>,
    /// The gradient.
    pub gradient: Vector12,
    /// The Hessian; positive semi-definite where its producer projects it.
    pub hessian: Matrix12,
}

/// The gradient and the Hessian of one energy term with respect to any number of vertices.
#[derive(Clone, Debug)]
pub(crate) struct Patch {
    /// The vertices.
    pub(crate) vertices: Vec<u32>,
    /// The gradient, three coordinates a vertex.
    pub(crate) gradient: DVector<f64>,
    /// The Hessian.
    pub(crate) hessian: DMatrix<f64>,
}

/// The derivatives of one energy term, as they enter a sum.
pub(crate) trait Term {
    /// The vertices.
    fn vertices(&self) -> &[u32];
    /// The gradient with respect to the vertex at this place.
    fn force(&self, place: usize) -> Vector3<f64>;
    /// The block of the Hessian for the vertices at these places.
    fn block(&self, row: usize, column: usize) -> Matrix3<f64>;
}

impl Term for Element {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn force(&self, place: usize) -> Vector3<f64> {
        Self::force(self, place)
    }

    fn block(&self, row: usize, column: usize) -> Matrix3<f64> {
        Self::block(self, row, column)
    }
}

impl Term for Patch {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn force(&self, place: usize) -> Vector3<f64> {
        self.gradient.fixed_rows::<3>(3 * place).into_owned()
    }

    fn block(&self, row: usize, column: usize) -> Matrix3<f64> {
        self.hessian.fixed_view::<3, 3>(3 * row, 3 * column).into_owned()
    }
}

impl Element {
    /// The gradient with respect to the vertex at index `place` of `vertices`.
    #[must_use]
    pub fn force(&self, place: usize) -> Vector3<f64> {
        self.gradient.fixed_rows::<3>(3 * place).into_owned()
    }

    /// The block of the Hessian for the vertices at indices `row` and `column` of `vertices`.
    #[must_use]
    pub fn block(&self, row: usize, column: usize) -> Matrix3<f64> {
        self.hessian.fixed_view::<3, 3>(3 * row, 3 * column).into_owned()
    }

    /// The element, multiplied by a factor.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        self.gradient *= factor;
        self.hessian *= factor;
        self
    }
}
