//! The moduli of isotropic linear elasticity.

use serde::{Deserialize, Serialize};

/// Young's modulus and Poisson's ratio.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ElasticModuli {
    /// Young's modulus E in Pa.
    pub young: f64,
    /// Poisson's ratio ν.
    pub poisson: f64,
}

/// An elastic modulus that is out of range.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ModuliError {
    /// Young's modulus is not positive.
    #[error("Young's modulus is {0}, expected a positive number")]
    Young(f64),
    /// Poisson's ratio is out of range.
    #[error("Poisson's ratio is {0}, expected a number in [0, 0.5)")]
    Poisson(f64),
}

impl ModuliError {
    /// The name of the modulus among the fields of [`ElasticModuli`].
    #[must_use]
    pub fn field(&self) -> &'static str {
        match self {
            Self::Young(_) => "young",
            Self::Poisson(_) => "poisson",
        }
    }
}

impl ElasticModuli {
    /// Checks that E > 0 and 0 ≤ ν < ½.
    ///
    /// # Errors
    /// [`ModuliError`] names the modulus that is out of range.
    pub fn check(&self) -> Result<(), ModuliError> {
        if !(self.young > 0.0 && self.young.is_finite()) {
            return Err(ModuliError::Young(self.young));
        }
        if !(0.0..0.5).contains(&self.poisson) {
            return Err(ModuliError::Poisson(self.poisson));
        }
        Ok(())
    }

    /// The shear modulus μ in Pa.
    #[must_use]
    pub fn shear(&self) -> f64 {
        0.5 * self.young / (1.0 + self.poisson)
    }

    /// Lamé's first parameter λ in Pa.
    #[must_use]
    pub fn lambda(&self) -> f64 {
        self.young * self.poisson / ((1.0 + self.poisson) * (1.0 - 2.0 * self.poisson))
    }

    /// λ under plane stress, as in a thin plate: E ν / (1 − ν²), in Pa.
    #[must_use]
    pub fn plane_lambda(&self) -> f64 {
        self.young * self.poisson / (1.0 - self.poisson * self.poisson)
    }

    /// The flexural rigidity of a plate of thickness h: E h³ / (12 (1 − ν²)), in N m.
    #[must_use]
    pub fn flexural_rigidity(&self, thickness: f64) -> f64 {
        self.young * thickness.powi(3) / (12.0 * (1.0 - self.poisson * self.poisson))
    }
}
