//! Linear tetrahedra.

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, DVector, Matrix3, SMatrix};
use serde::{Deserialize, Serialize};

use super::isotropic::{Curvature, Isotropic};
use super::lame::ElasticModuli;
use super::neo_hookean::NeoHookean;
use super::stable_neo_hookean::StableNeoHookean;
use crate::energy::{Energy, Projection, gather};

/// The hyperelastic energy of a solid. A new one is the last: fingerprints of checkpoints have the number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SolidMaterial {
    /// Ψ = μ/2 (tr FᵀF − 3) − μ ln J + λ/2 ln² J with J = det F (J. Bonet, R. D. Wood, *Nonlinear Continuum
    /// Mechanics for Finite Element Analysis*): infinite for inverted elements, so that no element inverts.
    #[default]
    NeoHookean,
    /// The stable neo-Hookean energy (B. Smith, F. de Goes, T. Kim, 2018): finite for every deformation.
    /// Elements can invert.
    StableNeoHookean,
}

/// A tetrahedron with constant deformation gradient.
///
/// Linear tetrahedra lock in bending: a beam that is one cell thick deflects by about a quarter of the
/// deflection of beam theory.
#[derive(Debug)]
pub(crate) struct Tetrahedron<M> {
    vertices: [u32; 4],
    /// Row i is the gradient of vertex i's barycentric coordinate.
    shape: SMatrix<f64, 4, 3>,
    volume: f64,
    density: M,
}

/// The energy of a tetrahedron of these vertices, with the positions of all vertices at rest, and its volume
/// at rest, in m³. `None` if its volume at rest is not positive.
pub(crate) fn tetrahedron(
    vertices: [u32; 4],
    rest: &[Point],
    material: SolidMaterial,
    moduli: ElasticModuli,
) -> Option<(Box<dyn Energy>, f64)> {
    let [a, b, c, d] = gather(rest, &vertices);
    let edges = Matrix3::from_columns(&[b - a, c - a, d - a]);
    let volume = edges.determinant() / 6.0;
    let inverse = edges.try_inverse().filter(|_| volume > 0.0)?;
    let mut shape = SMatrix::<f64, 4, 3>::zeros();
    shape.fixed_view_mut::<3, 3>(1, 0).copy_from(&inverse);
    shape.set_row(0, &-inverse.row_sum());
    let element = Tetrahedron {
        vertices,
        shape,
        volume,
        density: (),
    };
    let energy: Box<dyn Energy> = match material {
        SolidMaterial::NeoHookean => Box::new(element.of(NeoHookean::new(moduli))),
        SolidMaterial::StableNeoHookean => Box::new(element.of(StableNeoHookean::new(moduli))),
    };
    Some((energy, volume))
}

impl<M> Tetrahedron<M> {
    /// The same tetrahedron with another energy density.
    fn of<N>(self, density: N) -> Tetrahedron<N> {
        let Self {
            vertices,
            shape,
            volume,
            ..
        } = self;
        Tetrahedron {
            vertices,
            shape,
            volume,
            density,
        }
    }

    fn deformation(&self, points: &[Point]) -> Matrix3<f64> {
        let [a, b, c, d] = gather(points, &self.vertices);
        Matrix3::from_columns(&[b - a, c - a, d - a]) * self.shape.fixed_view::<3, 3>(1, 0)
    }
}

impl<M: Isotropic> Energy for Tetrahedron<M> {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn value(&self, points: &[Point]) -> f64 {
        self.volume * self.density.value(&self.deformation(points))
    }

    fn gradient(&self, points: &[Point]) -> DVector<f64> {
        // F is linear in the points. Its column c is Σᵢ xᵢ shape(i, c).
        let stress = self.density.stress(&self.deformation(points));
        let forces = stress * self.shape.transpose() * self.volume;
        DVector::from_column_slice(forces.as_slice())
    }

    fn hessian(&self, points: &[Point], projection: Projection) -> DMatrix<f64> {
        let curvature = Curvature::new(&self.density, &self.deformation(points), projection);
        let shape = [0, 1, 2, 3].map(|i: usize| curvature.in_frame(&self.shape.row(i).transpose()));
        let mut hessian = DMatrix::zeros(12, 12);
        for i in 0..4 {
            for j in 0..=i {
                let block = curvature.block(&shape[i], &shape[j]) * self.volume;
                hessian.fixed_view_mut::<3, 3>(3 * i, 3 * j).copy_from(&block);
                hessian
                    .fixed_view_mut::<3, 3>(3 * j, 3 * i)
                    .copy_from(&block.transpose());
            }
        }
        hessian
    }
}
