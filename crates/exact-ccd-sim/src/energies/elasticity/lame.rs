//! The moduli of isotropic linear elasticity.

use crate::range::{OutOfRange, check, check_positive};

/// Young's modulus and Poisson's ratio.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ElasticModuli {
    /// Young's modulus E in Pa.
    pub(crate) young: f64,
    /// Poisson's ratio ν.
    pub(crate) poisson: f64,
}

/// The Lamé parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lame {
    /// The shear modulus μ in Pa.
    pub(crate) mu: f64,
    /// λ in Pa.
    pub(crate) lambda: f64,
}

impl ElasticModuli {
    /// Checks that E > 0 and 0 ≤ ν < ½.
    ///
    /// # Errors
    /// [`OutOfRange`] names the modulus that is out of range.
    pub(crate) fn check(&self) -> Result<(), OutOfRange> {
        check_positive("young", self.young)?;
        let poisson = self.poisson;
        check(
            (0.0..0.5).contains(&poisson),
            "poisson",
            poisson,
            "a number in [0, 0.5)",
        )
    }

    /// The shear modulus μ in Pa.
    pub(crate) fn shear(&self) -> f64 {
        0.5 * self.young / (1.0 + self.poisson)
    }

    /// The Lamé parameters.
    pub(crate) fn lame(&self) -> Lame {
        Lame {
            mu: self.shear(),
            lambda: self.young * self.poisson / ((1.0 + self.poisson) * (1.0 - 2.0 * self.poisson)),
        }
    }

    /// λ under plane stress, as in a thin plate: E ν / (1 − ν²), in Pa.
    pub(crate) fn plane_lambda(&self) -> f64 {
        self.young * self.poisson / (1.0 - self.poisson * self.poisson)
    }

    /// The flexural rigidity of a plate of thickness h: E h³ / (12 (1 − ν²)), in N m.
    pub(crate) fn flexural_rigidity(&self, thickness: f64) -> f64 {
        self.young * thickness.powi(3) / (12.0 * (1.0 - self.poisson * self.poisson))
    }
}
