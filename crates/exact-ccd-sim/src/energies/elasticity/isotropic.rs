//! Isotropic hyperelasticity: energy densities that depend on the singular values of the deformation
//! gradient F.

use std::fmt::Debug;

use nalgebra::{Matrix3, Vector3};

use super::singular_values::{PAIRS, rotation_variant};
use crate::energies::term::Projection;

/// An isotropic energy density Ψ(F), in J/m³.
pub(crate) trait Isotropic: Debug + Send + Sync {
    /// Ψ(F). Infinite for deformations that the material excludes.
    fn value(&self, deformation: &Matrix3<f64>) -> f64;

    /// The first Piola-Kirchhoff stress ∂Ψ/∂F, in Pa.
    fn stress(&self, deformation: &Matrix3<f64>) -> Matrix3<f64>;

    /// The second derivatives in the frame of the singular vectors. The product of the singular values
    /// `stretches` is det F.
    fn principal(&self, stretches: &Vector3<f64>) -> Principal;
}

/// The second derivatives of Ψ(σ₁, σ₂, σ₃) in the frame of the singular vectors of F = U diag(σ) Vᵀ.
///
/// In this frame the Hessian is block diagonal, with one 3 × 3 block and three pairs of modes: A. Stomakhin,
/// R. Howes, C. Schroeder, J. Teran, *Energetically consistent invertible elasticity*, 2012. The names of
/// the modes are from B. Smith, F. de Goes, T. Kim, *Analytic eigensystems for isotropic distortion
/// energies*, 2019.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Principal {
    /// ∂²Ψ/∂σᵢ∂σⱼ.
    pub(crate) stretch: Matrix3<f64>,
    /// (∂ᵢΨ + ∂ⱼΨ) / (σᵢ + σⱼ) for the pairs (i, j) = (1, 2), (2, 0), (0, 1): the rotation in the plane of i
    /// and j.
    pub(crate) twist: [f64; 3],
    /// (∂ᵢΨ − ∂ⱼΨ) / (σᵢ − σⱼ) for the same pairs: the shear in the plane of i and j.
    pub(crate) flip: [f64; 3],
}

/// The Hessian of Ψ at F = U diag(σ) Vᵀ, stored in the frame of the singular vectors, where it is sparse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Curvature {
    u: Matrix3<f64>,
    v: Matrix3<f64>,
    /// ∂²Ψ/∂Fᵢᵢ∂Fⱼⱼ.
    stretch: Matrix3<f64>,
    /// ∂²Ψ/∂Fᵢⱼ². It has the same diagonal as `stretch`.
    own: Matrix3<f64>,
    /// ∂²Ψ/∂Fᵢⱼ∂Fⱼᵢ for i ≠ j, zero on the diagonal.
    crossed: Matrix3<f64>,
}

impl Curvature {
    /// The Hessian at a deformation gradient. Its eigenvalues are projected.
    pub(crate) fn new(energy: &impl Isotropic, deformation: &Matrix3<f64>, projection: Projection) -> Self {
        let (u, stretches, v) = rotation_variant(deformation);
        let mut principal = energy.principal(&stretches);
        principal.stretch = projection.of(principal.stretch);
        principal.twist = principal.twist.map(|value| projection.of_value(value));
        principal.flip = principal.flip.map(|value| projection.of_value(value));
        let (mut own, mut crossed) = (
            Matrix3::from_diagonal(&principal.stretch.diagonal()),
            Matrix3::zeros(),
        );
        for (pair, [i, j]) in PAIRS.into_iter().enumerate() {
            let (twist, flip) = (0.5 * principal.twist[pair], 0.5 * principal.flip[pair]);
            (own[(i, j)], own[(j, i)]) = (flip + twist, flip + twist);
            (crossed[(i, j)], crossed[(j, i)]) = (flip - twist, flip - twist);
        }
        Self {
            u,
            v,
            stretch: principal.stretch,
            own,
            crossed,
        }
    }

    /// A row vector in the frame of V, as [`Curvature::block`] expects.
    #[must_use]
    pub(crate) fn in_frame(&self, row: &Vector3<f64>) -> Vector3<f64> {
        self.v.tr_mul(row)
    }

    /// The second derivatives by two points x and y on which F depends as x aᵀ and y bᵀ. `a` and `b` are in
    /// the frame of V.
    #[must_use]
    pub(crate) fn block(&self, a: &Vector3<f64>, b: &Vector3<f64>) -> Matrix3<f64> {
        let products = a.component_mul(b);
        let diagonal = self.own * products;
        let block = Matrix3::from_fn(|i, k| {
            if i == k {
                diagonal[i]
            } else {
                a[i] * b[k] * self.stretch[(i, k)] + a[k] * b[i] * self.crossed[(i, k)]
            }
        });
        self.u * block * self.u.transpose()
    }
}
