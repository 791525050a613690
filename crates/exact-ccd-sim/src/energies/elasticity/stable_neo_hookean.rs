//! The stable neo-Hookean material.

use nalgebra::{Matrix3, Vector3};

use super::isotropic::{Isotropic, Principal};
use super::lame::ElasticModuli;
use super::neo_hookean::cofactor;

/// Ψ = μ/2 (I − 3) + λ/2 (J − α)² − μ/2 ln (I + 1) with I = tr FᵀF and J = det F, minus its value at rest. It
/// is finite and smooth for every deformation.
///
/// Source: B. Smith, F. de Goes, T. Kim, *Stable neo-Hookean flesh simulation*, ACM Transactions on Graphics
/// 37(2), 2018, equation 14.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StableNeoHookean {
    mu: f64,
    lambda: f64,
    alpha: f64,
}

impl StableNeoHookean {
    /// The material that has these moduli at small strains (section 3.4 of the paper).
    #[must_use]
    pub(crate) fn new(moduli: ElasticModuli) -> Self {
        let small = moduli.lame();
        let mu = 4.0 / 3.0 * small.mu;
        let lambda = small.lambda + 5.0 / 6.0 * small.mu;
        // With this α, the stress vanishes at rest, where I = 3 and J = 1.
        let alpha = 1.0 + 0.75 * mu / lambda;
        Self { mu, lambda, alpha }
    }

    fn shear(&self, squares: f64) -> f64 {
        self.mu * (1.0 - 1.0 / (squares + 1.0))
    }
}

impl Isotropic for StableNeoHookean {
    fn value(&self, f: &Matrix3<f64>) -> f64 {
        let (squares, volume, rest) = (f.norm_squared(), f.determinant() - self.alpha, 1.0 - self.alpha);
        0.5 * self.mu * (squares - 3.0) + 0.5 * self.lambda * (volume * volume - rest * rest)
            - 0.5 * self.mu * ((squares + 1.0) / 4.0).ln()
    }

    fn stress(&self, f: &Matrix3<f64>) -> Matrix3<f64> {
        f * self.shear(f.norm_squared()) + cofactor(f) * (self.lambda * (f.determinant() - self.alpha))
    }

    fn principal(&self, s: &Vector3<f64>) -> Principal {
        let squares = s.norm_squared();
        let shear = self.shear(squares);
        let bend = 2.0 * self.mu / (squares + 1.0).powi(2);
        let pressure = self.lambda * (s.product() - self.alpha);
        let cofactors = Vector3::new(s[1] * s[2], s[2] * s[0], s[0] * s[1]);
        let stretch = Matrix3::from_fn(|i, j| {
            let common = bend * s[i] * s[j] + self.lambda * cofactors[i] * cofactors[j];
            if i == j {
                common + shear
            } else {
                common + pressure * s[3 - i - j]
            }
        });
        Principal {
            stretch,
            twist: [0, 1, 2].map(|k: usize| shear + pressure * s[k]),
            flip: [0, 1, 2].map(|k: usize| shear - pressure * s[k]),
        }
    }
}
