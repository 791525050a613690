//! Coulomb's law of friction, smoothed near zero slip.

/// The smoothed friction function f₀ and its derivatives. f₁ = f₀′ rises smoothly from 0 at zero slip to 1
/// at the slip `threshold`, and is 1 beyond.
///
/// Source: *Incremental Potential Contact*, section 5.2 and supplement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Smoothing {
    /// The slip, in m, below which friction counts as static: ε_v h of the paper.
    pub(crate) threshold: f64,
}

impl Smoothing {
    /// f₀, in m: the integral of f₁.
    pub(crate) fn potential(&self, slip: f64) -> f64 {
        let e = self.threshold;
        if slip < e {
            slip * slip / e * (1.0 - slip / (3.0 * e)) + e / 3.0
        } else {
            slip
        }
    }

    /// f₁(y) / y, in 1/m.
    pub(crate) fn force_over_slip(&self, slip: f64) -> f64 {
        let e = self.threshold;
        if slip < e {
            (2.0 - slip / e) / e
        } else {
            slip.recip()
        }
    }

    /// f₁′(y), in 1/m.
    pub(crate) fn stiffness(&self, slip: f64) -> f64 {
        let e = self.threshold;
        if slip < e { 2.0 * (1.0 - slip / e) / e } else { 0.0 }
    }
}
