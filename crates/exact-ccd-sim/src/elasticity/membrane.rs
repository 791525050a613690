//! In-plane deformation of thin shells.

use arrayvec::ArrayVec;
use nalgebra::{Matrix2, Matrix3x2, SMatrix, Vector3};

use super::lame::ElasticModuli;
use crate::element::{Element, Matrix12, Vector12};
use crate::psd;

/// A triangle of a thin shell under plane stress, with the Saint Venant-Kirchhoff energy
/// h A (μ |E|² + λ/2 tr² E) of the strain E = ½ (FᵀF − 1) in the plane of the triangle.
#[derive(Clone, Debug)]
pub struct Membrane {
    vertices: [u32; 3],
    /// Row i is the gradient of vertex i's barycentric coordinate, in coordinates of the plane at rest.
    shape: SMatrix<f64, 3, 2>,
    area: f64,
    thickness: f64,
    mu: f64,
    lambda: f64,
}

impl Membrane {
    /// The triangle of these vertices, with its rest shape. `None` if it has no area at rest.
    #[must_use]
    pub fn new(
        vertices: [u32; 3],
        rest: &[Vector3<f64>; 3],
        thickness: f64,
        moduli: ElasticModuli,
    ) -> Option<Self> {
        let (a, b) = (rest[1] - rest[0], rest[2] - rest[0]);
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
        })
    }

    /// The vertices.
    #[must_use]
    pub fn vertices(&self) -> [u32; 3] {
        self.vertices
    }

    /// The volume at rest, in m³.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.area * self.thickness
    }

    /// The energy in J, for these positions of the vertices.
    #[must_use]
    pub fn value(&self, points: &[Vector3<f64>; 3]) -> f64 {
        let strain = strain(&self.deformation(points));
        let trace = strain.trace();
        self.volume() * (self.mu * strain.norm_squared() + 0.5 * self.lambda * trace * trace)
    }

    /// The gradient of the energy.
    #[must_use]
    pub fn gradient(&self, points: &[Vector3<f64>; 3]) -> Vector12 {
        let f = self.deformation(points);
        let forces = f * self.stress(&strain(&f)) * self.shape.transpose() * self.volume();
        let mut gradient = Vector12::zeros();
        gradient.fixed_rows_mut::<9>(0).copy_from_slice(forces.as_slice());
        gradient
    }

    /// The gradient and the Hessian of the energy. If `projected`, the Hessian is positive semi-definite.
    #[must_use]
    pub fn derivatives(&self, points: &[Vector3<f64>; 3], projected: bool) -> Element {
        let f = self.deformation(points);
        let stress = self.stress(&strain(&f));

        // The Hessian by the columns of F, stacked into one vector: dP = dF S + F dS.
        let mut second = SMatrix::<f64, 6, 6>::zeros();
        for column in 0..6 {
            let mut change = Matrix3x2::<f64>::zeros();
            change[column] = 1.0;
            let product = f.tr_mul(&change);
            let dstress = self.stress(&((product + product.transpose()) * 0.5));
            let dp = change * stress + f * dstress;
            second.set_column(column, &SMatrix::<f64, 6, 1>::from_column_slice(dp.as_slice()));
        }
        if projected {
            second = psd::project(second);
        }
        let map = SMatrix::<f64, 6, 9>::from_fn(|row, column| {
            if row % 3 == column % 3 {
                self.shape[(column / 3, row / 3)]
            } else {
                0.0
            }
        });
        let mut hessian = Matrix12::zeros();
        let block = map.tr_mul(&(second * map)) * self.volume();
        hessian.fixed_view_mut::<9, 9>(0, 0).copy_from(&block);
        Element {
            vertices: self.vertices.into_iter().collect::<ArrayVec<u32, 4>>(),
            gradient: self.gradient(points),
            hessian,
        }
    }

    fn deformation(&self, points: &[Vector3<f64>; 3]) -> Matrix3x2<f64> {
        let edges = Matrix3x2::from_columns(&[points[1] - points[0], points[2] - points[0]]);
        edges * self.shape.fixed_view::<2, 2>(1, 0)
    }

    /// The second Piola-Kirchhoff stress 2 μ E + λ tr E.
    fn stress(&self, strain: &Matrix2<f64>) -> Matrix2<f64> {
        strain * (2.0 * self.mu) + Matrix2::identity() * (self.lambda * strain.trace())
    }
}

/// The Green strain ½ (FᵀF − 1).
fn strain(f: &Matrix3x2<f64>) -> Matrix2<f64> {
    (f.tr_mul(f) - Matrix2::identity()) * 0.5
}
