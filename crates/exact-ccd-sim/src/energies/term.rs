//! The terms of energies. Every energy is a sum of terms.

use std::fmt::Debug;

use exact_ccd_mesh::Point;
use nalgebra::allocator::Allocator;
use nalgebra::{
    DMatrix, DefaultAllocator, Dim, DimDiff, DimName, DimSub, Matrix, Matrix3, OMatrix, SVector, Storage, U1,
    Vector3,
};

use super::psd;

/// The columns of a 3 × 3 block of a matrix.
pub(crate) type Block = [f64; 9];

/// One term of an energy, over some vertices. `points` has the positions of all vertices of the system.
///
/// Derivatives are written into slices, so that a sum of many terms needs no memory for each of them. The
/// former contents of a slice have no meaning.
pub(crate) trait Energy: Debug + Send + Sync {
    /// The vertices on which it depends, without repetition.
    fn vertices(&self) -> &[u32];

    /// The value. Infinite for positions that it excludes.
    fn value(&self, points: &[Point]) -> f64;

    /// Writes the gradient: three coordinates for each vertex.
    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]);

    /// Writes the Hessian: a block for each of the [`pairs`] of vertices.
    fn write_hessian(&self, points: &[Point], projection: Projection, hessian: &mut [Block]);

    /// Writes the gradient and the Hessian.
    fn write_derivatives(
        &self,
        points: &[Point],
        projection: Projection,
        gradient: &mut [f64],
        hessian: &mut [Block],
    ) {
        self.write_gradient(points, gradient);
        self.write_hessian(points, projection, hessian);
    }

    /// The gradient, three coordinates for each vertex.
    #[cfg(test)]
    fn gradient(&self, points: &[Point]) -> nalgebra::DVector<f64> {
        let mut gradient = nalgebra::DVector::zeros(3 * self.vertices().len());
        self.write_gradient(points, gradient.as_mut_slice());
        gradient
    }

    /// The Hessian, with the blocks of both triangles.
    fn hessian(&self, points: &[Point], projection: Projection) -> DMatrix<f64> {
        let count = self.vertices().len();
        let mut blocks = vec![[0.0; 9]; pair_count(count)];
        self.write_hessian(points, projection, &mut blocks);
        let mut hessian = DMatrix::zeros(3 * count, 3 * count);
        for ([row, column], block) in pairs(count).zip(&blocks) {
            let block = Matrix3::from_column_slice(block);
            for (row, column, block) in [(row, column, block), (column, row, block.transpose())] {
                hessian
                    .fixed_view_mut::<3, 3>(3 * row, 3 * column)
                    .copy_from(&block);
            }
        }
        hessian
    }
}

/// The pairs of places of vertices in the lower triangle, as row and column, column by column.
pub(crate) fn pairs(count: usize) -> impl Iterator<Item = [usize; 2]> {
    (0..count).flat_map(move |column| (column..count).map(move |row| [row, column]))
}

/// The number of [`pairs`].
pub(crate) fn pair_count(count: usize) -> usize {
    count * (count + 1) / 2
}

/// The projection of a Hessian.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Projection {
    /// The second derivatives; only tests compare them.
    #[cfg_attr(not(test), expect(dead_code, reason = "tests compare it with differences"))]
    None,
    /// A positive semi-definite matrix near them, so that a Newton direction decreases the sum.
    SemiDefinite,
}

impl Projection {
    /// The projection of a symmetric matrix.
    pub(crate) fn of<D>(self, matrix: OMatrix<f64, D, D>) -> OMatrix<f64, D, D>
    where
        D: DimName + DimSub<U1>,
        DefaultAllocator: Allocator<D, D> + Allocator<D> + Allocator<U1, D> + Allocator<DimDiff<D, U1>>,
    {
        match self {
            Self::None => matrix,
            Self::SemiDefinite => psd::project(matrix),
        }
    }

    /// The projection of an eigenvalue.
    pub(crate) fn of_value(self, value: f64) -> f64 {
        match self {
            Self::None => value,
            Self::SemiDefinite => value.max(0.0),
        }
    }
}

/// The positions of some vertices.
pub(crate) fn gather<const N: usize>(points: &[Point], vertices: &[u32; N]) -> [Vector3<f64>; N] {
    vertices.map(|vertex| Vector3::from(points[vertex as usize]))
}

/// The positions of at most four vertices. The missing ones are zero; their weights are zero too.
pub(crate) fn gather_some(points: &[Point], vertices: &[u32]) -> [Vector3<f64>; 4] {
    let at = |place: usize| {
        let vertex = vertices.get(place);
        vertex.map_or_else(Vector3::zeros, |&vertex| Vector3::from(points[vertex as usize]))
    };
    [at(0), at(1), at(2), at(3)]
}

/// Writes a gradient by the first vertices of an element.
pub(crate) fn write_rows<const N: usize>(vector: &SVector<f64, N>, gradient: &mut [f64]) {
    let count = gradient.len();
    gradient.copy_from_slice(&vector.as_slice()[..count]);
}

/// Writes a Hessian by the first vertices of an element.
pub(crate) fn write_blocks<R: Dim, C: Dim, S: Storage<f64, R, C>>(
    matrix: &Matrix<f64, R, C, S>,
    vertices: usize,
    hessian: &mut [Block],
) {
    let block = |[row, column]: [usize; 2]| matrix.fixed_view::<3, 3>(3 * row, 3 * column).into_owned();
    write_each(pairs(vertices).map(block), hessian);
}

/// Writes blocks in the order of the [`pairs`].
pub(crate) fn write_each(blocks: impl IntoIterator<Item = Matrix3<f64>>, hessian: &mut [Block]) {
    for (to, block) in hessian.iter_mut().zip(blocks) {
        to.copy_from_slice(block.as_slice());
    }
}

/// Writes the Hessian of an energy of Σ wₖ xₖ, from the second derivatives by this sum.
pub(crate) fn write_products(weights: &[f64], second: &Matrix3<f64>, hessian: &mut [Block]) {
    let block = |[row, column]: [usize; 2]| second * (weights[row] * weights[column]);
    write_each(pairs(weights.len()).map(block), hessian);
}
