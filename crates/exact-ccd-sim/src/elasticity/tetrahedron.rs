//! Linear tetrahedra.

use arrayvec::ArrayVec;
use nalgebra::{Matrix3, SMatrix, Vector3};
use serde::{Deserialize, Serialize};

use super::isotropic::{Curvature, Isotropic};
use super::lame::ElasticModuli;
use super::neo_hookean::NeoHookean;
use super::stable_neo_hookean::StableNeoHookean;
use crate::element::{Element, Matrix12, Vector12};

/// The hyperelastic energy of a solid.
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
#[derive(Clone, Debug)]
pub struct Tetrahedron {
    vertices: [u32; 4],
    /// Row i is the gradient of vertex i's barycentric coordinate.
    shape: SMatrix<f64, 4, 3>,
    volume: f64,
    energy: Energy,
}

#[derive(Clone, Copy, Debug)]
enum Energy {
    NeoHookean(NeoHookean),
    Stable(StableNeoHookean),
}

impl Tetrahedron {
    /// The tetrahedron of these vertices, with its rest shape. `None` if its volume at rest is not positive.
    #[must_use]
    pub fn new(
        vertices: [u32; 4],
        rest: &[Vector3<f64>; 4],
        material: SolidMaterial,
        moduli: ElasticModuli,
    ) -> Option<Self> {
        let edges = Matrix3::from_columns(&[rest[1] - rest[0], rest[2] - rest[0], rest[3] - rest[0]]);
        let volume = edges.determinant() / 6.0;
        let inverse = edges.try_inverse().filter(|_| volume > 0.0)?;
        let mut shape = SMatrix::<f64, 4, 3>::zeros();
        shape.fixed_view_mut::<3, 3>(1, 0).copy_from(&inverse);
        shape.set_row(0, &-inverse.row_sum());
        let energy = match material {
            SolidMaterial::NeoHookean => Energy::NeoHookean(NeoHookean::new(moduli)),
            SolidMaterial::StableNeoHookean => Energy::Stable(StableNeoHookean::new(moduli)),
        };
        Some(Self {
            vertices,
            shape,
            volume,
            energy,
        })
    }

    /// The vertices.
    #[must_use]
    pub fn vertices(&self) -> [u32; 4] {
        self.vertices
    }

    /// The volume at rest, in m³.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.volume
    }

    /// The energy in J, for these positions of the vertices.
    #[must_use]
    pub fn value(&self, points: &[Vector3<f64>; 4]) -> f64 {
        let f = self.deformation(points);
        self.volume
            * match &self.energy {
                Energy::NeoHookean(energy) => energy.value(&f),
                Energy::Stable(energy) => energy.value(&f),
            }
    }

    /// The gradient of the energy.
    #[must_use]
    pub fn gradient(&self, points: &[Vector3<f64>; 4]) -> Vector12 {
        let f = self.deformation(points);
        let stress = match &self.energy {
            Energy::NeoHookean(energy) => energy.stress(&f),
            Energy::Stable(energy) => energy.stress(&f),
        };
        // F is linear in the points. Its column c is Σᵢ xᵢ shape(i, c).
        let forces = stress * self.shape.transpose() * self.volume;
        Vector12::from_column_slice(forces.as_slice())
    }

    /// The gradient and the Hessian of the energy. If `projected`, the Hessian is positive semi-definite.
    #[must_use]
    pub fn derivatives(&self, points: &[Vector3<f64>; 4], projected: bool) -> Element {
        let f = self.deformation(points);
        let curvature = match &self.energy {
            Energy::NeoHookean(energy) => Curvature::new(energy, &f, projected),
            Energy::Stable(energy) => Curvature::new(energy, &f, projected),
        };
        let shape = [0, 1, 2, 3].map(|i: usize| curvature.in_frame(&self.shape.row(i).transpose()));
        let mut hessian = Matrix12::zeros();
        for i in 0..4 {
            for j in 0..=i {
                let block = curvature.block(&shape[i], &shape[j]) * self.volume;
                hessian.fixed_view_mut::<3, 3>(3 * i, 3 * j).copy_from(&block);
                hessian
                    .fixed_view_mut::<3, 3>(3 * j, 3 * i)
                    .copy_from(&block.transpose());
            }
        }
        Element {
            vertices: ArrayVec::from(self.vertices),
            gradient: self.gradient(points),
            hessian,
        }
    }

    fn deformation(&self, points: &[Vector3<f64>; 4]) -> Matrix3<f64> {
        let origin = points[0];
        let edges = SMatrix::<f64, 3, 3>::from_columns(&[1, 2, 3].map(|i: usize| points[i] - origin));
        edges * self.shape.fixed_view::<3, 3>(1, 0)
    }
}
