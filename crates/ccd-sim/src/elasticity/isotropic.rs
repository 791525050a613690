//! Isotropic hyperelasticity: energy densities that depend on the deformation gradient F by its singular values.

use nalgebra::{Matrix3, SMatrix, Vector3};

use crate::psd;

/// An isotropic energy density Ψ(F), in J/m³.
pub trait Isotropic {
    /// Ψ(F); infinite where the material cannot be.
    fn value(&self, deformation: &Matrix3<f64>) -> f64;

    /// The first Piola-Kirchhoff stress ∂Ψ/∂F, in Pa.
    fn stress(&self, deformation: &Matrix3<f64>) -> Matrix3<f64>;

    /// The second derivatives in the frame of the singular vectors, for singular values whose product is det F.
    fn principal(&self, stretches: &Vector3<f64>) -> Principal;
}

/// The second derivatives of Ψ(σ₁, σ₂, σ₃) in the frame of the singular vectors of F = U diag(σ) Vᵀ.
///
/// In this frame the Hessian falls apart into one block of three and three pairs of modes: A. Stomakhin, R. Howes,
/// C. Schroeder, J. Teran, *Energetically consistent invertible elasticity*, 2012; the modes are named as by B. Smith,
/// F. de Goes, T. Kim, *Analytic eigensystems for isotropic distortion energies*, 2019.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Principal {
    /// ∂²Ψ/∂σᵢ∂σⱼ.
    pub stretch: Matrix3<f64>,
    /// (∂ᵢΨ + ∂ⱼΨ) / (σᵢ + σⱼ) for the pairs (i, j) = (1, 2), (2, 0), (0, 1): the rotation of i against j.
    pub twist: [f64; 3],
    /// (∂ᵢΨ − ∂ⱼΨ) / (σᵢ − σⱼ) for the same pairs: the shear of i against j.
    pub flip: [f64; 3],
}

/// The pairs of axes of [`Principal::twist`] and [`Principal::flip`].
pub(super) const PAIRS: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];

/// The Hessian of Ψ with respect to the columns of F, one below the other; if `projected`, with its negative
/// eigenvalues set to zero.
#[must_use]
pub fn hessian(energy: &impl Isotropic, deformation: &Matrix3<f64>, projected: bool) -> SMatrix<f64, 9, 9> {
    let (u, stretches, v) = rotation_variant(deformation);
    let mut principal = energy.principal(&stretches);
    if projected {
        principal.stretch = psd::project(principal.stretch);
        principal.twist = principal.twist.map(|value| value.max(0.0));
        principal.flip = principal.flip.map(|value| value.max(0.0));
    }

    let mode = |i: usize, j: usize| {
        let outer = u.column(i) * v.column(j).transpose();
        SMatrix::<f64, 9, 1>::from_column_slice(outer.as_slice())
    };
    let stretch_modes = SMatrix::<f64, 9, 3>::from_columns(&[mode(0, 0), mode(1, 1), mode(2, 2)]);
    let mut hessian = stretch_modes * principal.stretch * stretch_modes.transpose();
    for (pair, [i, j]) in PAIRS.into_iter().enumerate() {
        let (ij, ji) = (mode(i, j), mode(j, i));
        let (twist, flip) = (ij - ji, ij + ji);
        hessian.ger(0.5 * principal.twist[pair], &twist, &twist, 1.0);
        hessian.ger(0.5 * principal.flip[pair], &flip, &flip, 1.0);
    }
    hessian
}

/// F = U diag(σ) Vᵀ with U Vᵀ a rotation: if F turns space inside out, the last σ is negative.
fn rotation_variant(f: &Matrix3<f64>) -> (Matrix3<f64>, Vector3<f64>, Matrix3<f64>) {
    let svd = f.svd(true, true);
    let (Some(mut u), Some(v_t)) = (svd.u, svd.v_t) else {
        return (Matrix3::identity(), f.diagonal(), Matrix3::identity());
    };
    let mut stretches = svd.singular_values;
    if (u * v_t).determinant() < 0.0 {
        stretches[2] = -stretches[2];
        let flipped = -u.column(2);
        u.set_column(2, &flipped);
    }
    (u, stretches, v_t.transpose())
}
