//! The terms of which all energies are sums.

use std::fmt::Debug;

use exact_ccd_mesh::Point;
use nalgebra::allocator::Allocator;
use nalgebra::{
    DMatrix, DVector, DefaultAllocator, DimDiff, DimName, DimSub, OMatrix, SMatrix, SVector, U1, Vector3,
};

use crate::psd;

/// One term of an energy, over some vertices. `points` has the positions of all vertices of the system.
pub(crate) trait Energy: Debug + Send + Sync {
    /// The vertices on which it depends, without repetition.
    fn vertices(&self) -> &[u32];

    /// The value. Infinite for positions that it excludes.
    fn value(&self, points: &[Point]) -> f64;

    /// The gradient, three coordinates for each vertex.
    fn gradient(&self, points: &[Point]) -> DVector<f64>;

    /// The Hessian, a 3 × 3 block for each pair of vertices.
    fn hessian(&self, points: &[Point], projection: Projection) -> DMatrix<f64>;
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

/// A gradient by the first vertices of an element.
pub(crate) fn first_rows<const N: usize>(gradient: &SVector<f64, N>, vertices: usize) -> DVector<f64> {
    gradient.rows(0, 3 * vertices).into_owned()
}

/// A Hessian by the first vertices of an element.
pub(crate) fn first_blocks<const N: usize>(hessian: &SMatrix<f64, N, N>, vertices: usize) -> DMatrix<f64> {
    hessian.view((0, 0), (3 * vertices, 3 * vertices)).into_owned()
}
