//! In-plane deformation of thin shells.

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3x2, SMatrix};

use super::lame::ElasticModuli;
use super::strain_limit::StrainLimit;
use crate::energy::{Energy, Projection, first_blocks, gather};

/// A triangle of a thin shell under plane stress, with the Saint Venant-Kirchhoff energy
/// h A (μ |E|² + λ/2 tr² E) of the strain E = ½ (FᵀF − 1) in the plane of the triangle. The stretches can
/// have a limit.
#[derive(Debug)]
pub(crate) struct Membrane {
    vertices: [u32; 3],
    /// Row i is the gradient of vertex i's barycentric coordinate, in coordinates of the plane at rest.
    shape: SMatrix<f64, 3, 2>,
    area: f64,
    thickness: f64,
    mu: f64,
    lambda: f64,
    limit: Option<StrainLimit>,
}

impl Membrane {
    /// The triangle of these vertices, with the positions of all vertices at rest. `None` if it has no area
    /// at rest.
    pub(crate) fn new(
        vertices: [u32; 3],
        rest: &[Point],
        thickness: f64,
        moduli: ElasticModuli,
    ) -> Option<Self> {
        let [origin, a, b] = gather(rest, &vertices);
        let (a, b) = (a - origin, b - origin);
        let area = 0.5 * a.cross(&b).norm();
        let along = a.try_normalize(0.0)?;
        let across = (b - along * along.dot(&b)).try_normalize(0.0)?;
        let plane = Matrix2::new(a.dot(&along), b.dot(&along), 0.0, b.dot(&across));
        let inverse = plane.try_inverse().filter(|_| area > 0.0)?;
        let mut shape = SMatrix::<f64, 3, 2>::zeros();
        shape.fixed_view_mut::<2, 2>(1, 0).copy_from(&inverse);
        shape.set_row(0, &-inverse.row_sum());
        Some(Self {
            vertices,
            shape,
            area,
            thickness,
            mu: moduli.shear(),
            lambda: moduli.plane_lambda(),
            limit: None,
        })
    }

    /// The same triangle with another limit of its stretches.
    pub(crate) fn with_limit(self, limit: Option<StrainLimit>) -> Self {
        Self { limit, ..self }
    }

    /// The volume at rest, in m³.
    pub(crate) fn volume(&self) -> f64 {
        self.area * self.thickness
    }

    fn deformation(&self, points: &[Point]) -> Matrix3x2<f64> {
        let [origin, a, b] = gather(points, &self.vertices);
        Matrix3x2::from_columns(&[a - origin, b - origin]) * self.shape.fixed_view::<2, 2>(1, 0)
    }

    /// The second Piola-Kirchhoff stress at C = FᵀF.
    fn stress(&self, c: &Matrix2<f64>) -> Matrix2<f64> {
        let stress = self.linear(&strain(c));
        match &self.limit {
            None => stress,
            Some(limit) => stress + limit.stress(c),
        }
    }

    /// The differential of the stress at C along dC.
    fn differential(&self, c: &Matrix2<f64>, change: &Matrix2<f64>) -> Matrix2<f64> {
        let differential = self.linear(&(change * 0.5));
        match &self.limit {
            None => differential,
            Some(limit) => differential + limit.differential(c, change),
        }
    }

    /// The stress 2 μ E + λ tr E without a limit.
    fn linear(&self, strain: &Matrix2<f64>) -> Matrix2<f64> {
        strain * (2.0 * self.mu) + Matrix2::identity() * (self.lambda * strain.trace())
    }
}

impl Energy for Membrane {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn value(&self, points: &[Point]) -> f64 {
        let f = self.deformation(points);
        let c = f.tr_mul(&f);
        let strain = strain(&c);
        let trace = strain.trace();
        let density = self.mu * strain.norm_squared() + 0.5 * self.lambda * trace * trace;
        let limited = self.limit.map_or(0.0, |limit| limit.value(&c));
        self.volume() * (density + limited)
    }

    fn gradient(&self, points: &[Point]) -> DVector<f64> {
        let f = self.deformation(points);
        let forces = f * self.stress(&f.tr_mul(&f)) * self.shape.transpose() * self.volume();
        DVector::from_column_slice(forces.as_slice())
    }

    fn hessian(&self, points: &[Point], projection: Projection) -> DMatrix<f64> {
        let f = self.deformation(points);
        let c = f.tr_mul(&f);
        let stress = self.stress(&c);

        // The Hessian by the columns of F, stacked into one vector: dP = dF S + F dS.
        let mut second = SMatrix::<f64, 6, 6>::zeros();
        for column in 0..6 {
            let mut change = Matrix3x2::<f64>::zeros();
            change[column] = 1.0;
            let product = f.tr_mul(&change);
            let dstress = self.differential(&c, &(product + product.transpose()));
            let dp = change * stress + f * dstress;
            second.set_column(column, &SMatrix::<f64, 6, 1>::from_column_slice(dp.as_slice()));
        }
        let map = SMatrix::<f64, 6, 9>::from_fn(|row, column| {
            if row % 3 == column % 3 {
                self.shape[(column / 3, row / 3)]
            } else {
                0.0
            }
        });
        first_blocks(&(map.tr_mul(&(projection.of(second) * map)) * self.volume()), 3)
    }
}

/// The Green strain ½ (C − 1) of C = FᵀF.
fn strain(c: &Matrix2<f64>) -> Matrix2<f64> {
    (c - Matrix2::identity()) * 0.5
}
