//! The compressible neo-Hookean material.

use nalgebra::{Matrix3, Vector3};

use super::isotropic::{Isotropic, Principal};
use super::lame::Lame;
use super::singular_values::PAIRS;

/// Ψ = μ/2 (tr FᵀF − 3) − μ ln J + λ/2 ln² J, which is infinite for J = det F ≤ 0.
///
/// Source: J. Bonet, R. D. Wood, *Nonlinear Continuum Mechanics for Finite Element Analysis*, section 6.4.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NeoHookean(pub(super) Lame);

impl Isotropic for NeoHookean {
    fn value(&self, f: &Matrix3<f64>) -> f64 {
        let determinant = f.determinant();
        if determinant <= 0.0 {
            return f64::INFINITY;
        }
        let log = determinant.ln();
        0.5 * self.0.mu * (f.norm_squared() - 3.0) - self.0.mu * log + 0.5 * self.0.lambda * log * log
    }

    fn stress(&self, f: &Matrix3<f64>) -> Matrix3<f64> {
        let determinant = f.determinant();
        let inverse_transpose = cofactor(f) / determinant;
        f * self.0.mu + inverse_transpose * (self.0.lambda * determinant.ln() - self.0.mu)
    }

    fn principal(&self, s: &Vector3<f64>) -> Principal {
        let log = s.product().ln();
        let pressure = self.0.mu - self.0.lambda * log;
        let stretch = Matrix3::from_fn(|i, j| {
            let off = self.0.lambda / (s[i] * s[j]);
            if i == j {
                self.0.mu + pressure / (s[i] * s[i]) + off
            } else {
                off
            }
        });
        let quotient = |[i, j]: [usize; 2]| pressure / (s[i] * s[j]);
        Principal {
            stretch,
            twist: PAIRS.map(|pair| self.0.mu - quotient(pair)),
            flip: PAIRS.map(|pair| self.0.mu + quotient(pair)),
        }
    }
}

/// The matrix of cofactors: the gradient of the determinant.
pub(super) fn cofactor(f: &Matrix3<f64>) -> Matrix3<f64> {
    let [a, b, c] = [0, 1, 2].map(|column| f.column(column).into_owned());
    Matrix3::from_columns(&[b.cross(&c), c.cross(&a), a.cross(&b)])
}
