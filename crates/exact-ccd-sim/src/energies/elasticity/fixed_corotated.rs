//! The fixed corotated material.

use nalgebra::{Matrix3, Vector3};

use super::isotropic::{Isotropic, Principal};
use super::lame::Lame;
use super::neo_hookean::cofactor;
use super::singular_values::{PAIRS, rotation_variant};

/// Ψ = μ |F − R|² + λ/2 (J − 1)² = μ Σ (σᵢ − 1)² + λ/2 (J − 1)², with the rotation R nearest to F.
///
/// Source: A. Stomakhin, R. Howes, C. Schroeder, J. Teran, *Energetically consistent invertible elasticity*,
/// 2012, section 3.2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FixedCorotated(pub(super) Lame);

impl Isotropic for FixedCorotated {
    fn value(&self, f: &Matrix3<f64>) -> f64 {
        let (_, stretches, _) = rotation_variant(f);
        let volume = f.determinant() - 1.0;
        self.0.mu * stretches.add_scalar(-1.0).norm_squared() + 0.5 * self.0.lambda * volume * volume
    }

    fn stress(&self, f: &Matrix3<f64>) -> Matrix3<f64> {
        let (u, _, v) = rotation_variant(f);
        let pressure = self.0.lambda * (f.determinant() - 1.0);
        (f - u * v.transpose()) * (2.0 * self.0.mu) + cofactor(f) * pressure
    }

    /// ∂ᵢΨ = 2 μ (σᵢ − 1) + λ (J − 1) σⱼ σₖ. No sum of two stretches is negative. Where one vanishes, R is
    /// not unique, and the twist is −∞, which projects to 0.
    fn principal(&self, s: &Vector3<f64>) -> Principal {
        let pressure = self.0.lambda * (s.product() - 1.0);
        let cofactors = Vector3::new(s[1] * s[2], s[2] * s[0], s[0] * s[1]);
        let stretch = Matrix3::from_fn(|i, j| {
            let common = self.0.lambda * cofactors[i] * cofactors[j];
            if i == j {
                common + 2.0 * self.0.mu
            } else {
                common + pressure * s[3 - i - j]
            }
        });
        let other = |[i, j]: [usize; 2]| s[3 - i - j];
        let turn = |[i, j]: [usize; 2]| 2.0 * self.0.mu * (1.0 - 2.0 / (s[i] + s[j]));
        Principal {
            stretch,
            twist: PAIRS.map(|pair| turn(pair) + pressure * other(pair)),
            flip: PAIRS.map(|pair| 2.0 * self.0.mu - pressure * other(pair)),
        }
    }
}
