//! The material of Saint Venant and Kirchhoff.

use nalgebra::{Matrix3, Vector3};

use super::isotropic::{Isotropic, Principal};
use super::lame::Lame;
use super::singular_values::PAIRS;

/// Ψ = μ tr E² + λ/2 tr² E with Green's strain E = (FᵀF − 1)/2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SaintVenantKirchhoff(pub(super) Lame);

impl SaintVenantKirchhoff {
    /// The density κ |FᵀF − 1|², which is zero for rotations: with μ = 4 κ and λ = 0.
    #[must_use]
    pub(crate) fn orthogonality(stiffness: f64) -> Self {
        Self(Lame {
            mu: 4.0 * stiffness,
            lambda: 0.0,
        })
    }
}

impl Isotropic for SaintVenantKirchhoff {
    fn value(&self, f: &Matrix3<f64>) -> f64 {
        let strain = strain(f);
        self.0.mu * strain.norm_squared() + 0.5 * self.0.lambda * strain.trace().powi(2)
    }

    fn stress(&self, f: &Matrix3<f64>) -> Matrix3<f64> {
        let strain = strain(f);
        let pressure = Matrix3::from_diagonal_element(self.0.lambda * strain.trace());
        f * (strain * (2.0 * self.0.mu) + pressure)
    }

    /// With a = tr E: ∂ᵢΨ = μ σᵢ³ + (λ a − μ) σᵢ, so that all quotients are polynomials.
    fn principal(&self, s: &Vector3<f64>) -> Principal {
        let trace = 0.5 * (s.norm_squared() - 3.0);
        let linear = self.0.lambda * trace - self.0.mu;
        let stretch = Matrix3::from_fn(|i, j| {
            let common = self.0.lambda * s[i] * s[j];
            if i == j {
                common + 3.0 * self.0.mu * s[i] * s[i] + linear
            } else {
                common
            }
        });
        let squares = |[i, j]: [usize; 2]| s[i] * s[i] + s[j] * s[j];
        let product = |[i, j]: [usize; 2]| s[i] * s[j];
        Principal {
            stretch,
            twist: PAIRS.map(|pair| self.0.mu * (squares(pair) - product(pair)) + linear),
            flip: PAIRS.map(|pair| self.0.mu * (squares(pair) + product(pair)) + linear),
        }
    }
}

fn strain(f: &Matrix3<f64>) -> Matrix3<f64> {
    (f.tr_mul(f) - Matrix3::identity()) * 0.5
}
