//! Projection of small symmetric matrices to positive semi-definite ones.

use nalgebra::allocator::Allocator;
use nalgebra::{Cholesky, DefaultAllocator, DimDiff, DimName, DimSub, OMatrix, OVector, SymmetricEigen, U1};

/// The maximal number of sweeps of the eigenvalue solver. Small symmetric matrices need far fewer.
const SWEEPS: usize = 1000;

/// The positive semi-definite matrix nearest to a symmetric one: negative eigenvalues are set to zero, as in
/// the projected Newton method (J. Teran, E. Sifakis, G. Irving, R. Fedkiw, *Robust quasistatic finite
/// elements and flesh simulation*, 2005).
///
/// If the eigenvalue solver fails or its result is not finite, the result is the diagonal matrix of the
/// absolute row sums, which is an upper bound of the matrix. A matrix with a non-finite entry is returned
/// unchanged.
pub(crate) fn project<D>(matrix: OMatrix<f64, D, D>) -> OMatrix<f64, D, D>
where
    D: DimName + DimSub<U1>,
    DefaultAllocator: Allocator<D, D> + Allocator<D> + Allocator<U1, D> + Allocator<DimDiff<D, U1>>,
{
    if !matrix.iter().all(|entry| entry.is_finite()) || Cholesky::new(matrix.clone()).is_some() {
        return matrix;
    }
    // The solver divides by zero where off-diagonal entries underflow.
    let eigen = SymmetricEigen::try_new(matrix.clone(), f64::EPSILON, SWEEPS);
    let is_finite = |eigen: &SymmetricEigen<f64, D>| eigen.eigenvectors.iter().all(|entry| entry.is_finite());
    let Some(eigen) = eigen.filter(is_finite) else {
        let sums = matrix.column_iter().map(|column| column.lp_norm(1));
        return OMatrix::from_diagonal(&OVector::<f64, D>::from_iterator(sums));
    };
    if eigen.eigenvalues.iter().all(|&value| value >= 0.0) {
        return matrix;
    }
    let mut projected = OMatrix::<f64, D, D>::zeros();
    for (&value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
        if value > 0.0 {
            projected.ger(value, &vector, &vector, 1.0);
        }
    }
    projected
}
