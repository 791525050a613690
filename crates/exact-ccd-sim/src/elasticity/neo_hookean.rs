//! The compressible neo-Hookean material.

use nalgebra::{Matrix3, Vector3};

use super::isotropic::{Isotropic, PAIRS, Principal};
use super::lame::ElasticModuli;

/// Ψ = μ/2 (tr FᵀF − 3) − μ ln J + λ/2 ln² J, which is infinite for J = det F ≤ 0.
///
/// Source: J. Bonet, R. D. Wood, *Nonlinear Continuum Mechanics for Finite Element Analysis*, section 6.4.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NeoHookean {
    mu: f64,
    lambda: f64,
}

impl NeoHookean {
    /// The material that has these moduli at small strains.
    #[must_use]
    pub(crate) fn new(moduli: ElasticModuli) -> Self {
        let (mu, lambda) = (moduli.shear(), moduli.lambda());
        Self { mu, lambda }
    }
}

impl Isotropic for NeoHookean {
    fn value(&self, f: &Matrix3<f64>) -> f64 {
        let determinant = f.determinant();
        if determinant <= 0.0 {
            return f64::INFINITY;
        }
        let log = determinant.ln();
        0.5 * self.mu * (f.norm_squared() - 3.0) - self.mu * log + 0.5 * self.lambda * log * log
    }

    fn stress(&self, f: &Matrix3<f64>) -> Matrix3<f64> {
        let determinant = f.determinant();
        let inverse_transpose = cofactor(f) / determinant;
        f * self.mu + inverse_transpose * (self.lambda * determinant.ln() - self.mu)
    }

    fn principal(&self, s: &Vector3<f64>) -> Principal {
        let log = s.product().ln();
        let pressure = self.mu - self.lambda * log;
        let stretch = Matrix3::from_fn(|i, j| {
            let off = self.lambda / (s[i] * s[j]);
            if i == j {
                self.mu + pressure / (s[i] * s[i]) + off
            } else {
                off
            }
        });
        let quotient = |[i, j]: [usize; 2]| pressure / (s[i] * s[j]);
        Principal {
            stretch,
            twist: PAIRS.map(|pair| self.mu - quotient(pair)),
            flip: PAIRS.map(|pair| self.mu + quotient(pair)),
        }
    }
}

/// The matrix of cofactors: the gradient of the determinant.
pub(super) fn cofactor(f: &Matrix3<f64>) -> Matrix3<f64> {
    let [a, b, c] = [0, 1, 2].map(|column| f.column(column).into_owned());
    Matrix3::from_columns(&[b.cross(&c), c.cross(&a), a.cross(&b)])
}
